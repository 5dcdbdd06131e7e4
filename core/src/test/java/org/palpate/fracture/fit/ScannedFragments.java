package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.palpate.fracture.PartialVoxels;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/**
 * Fragments as a scanner shows them: the part of each voxel that bone fills is its grey value, and
 * a threshold cuts bone out.
 */
final class ScannedFragments {
  private static final double THRESHOLD = 0.5;
  private static final double CONTRAST = 0.5;

  /** Samples of a scanned voxel along each axis. */
  private static final int SAMPLES = 3;

  /** Has the axes and the voxels of every scan. */
  private static final VoxelGrid SCANNER = VoxelGrid.ofUnitVoxels(1, 1, 1);

  final List<VoxelGrid> grids = new ArrayList<>();
  final List<BitCube> bits = new ArrayList<>();
  final List<Optional<PartialVoxels>> partial = new ArrayList<>();

  /** The pose of each fragment, from where the scan shows it to its true place. */
  final List<Pose> truth = new ArrayList<>();

  private ScannedFragments() {}

  /**
   * Scans fragments that lie apart, with voxels of 1 mm.
   *
   * @param fine the fragments in place, with voxels that are a few times as fine
   * @param random draws the motions
   */
  static ScannedFragments of(Fragments fine, SplittableRandom random) {
    ScannedFragments scan = new ScannedFragments();
    for (BitCube each : fine.bits()) {
      Pose scanned = new Pose();
      scanned.rotation.setRotationVector(
          RandomGeometry.direction(random).mul(random.nextDouble(0.15, 0.7), new Vec3()));
      scanned.translation.set(random.nextDouble(), random.nextDouble(), random.nextDouble());
      PosedBits fragment = new PosedBits(each, fine.grid(), scanned);
      ScalarVolume values = scanned(fragment, PosedBits.gridAround(List.of(fragment), SCANNER));
      BitCube largest = ConnectedComponents.largest(solid(values), Neighbours.FACES_EDGES_CORNERS);
      scan.add(largest, values, scanned.inverseMultiply(new Pose(), new Pose()));
    }
    return scan;
  }

  /**
   * Scans a whole bone with voxels of 1 mm, and cuts it in the scan, where grey values do not show
   * the cuts.
   *
   * @param fine the bone, with finer voxels
   * @param grid the grid of the scan
   */
  static ScannedFragments ofCut(PosedBits fine, VoxelGrid grid, FractureSpec fracture) {
    ScannedFragments scan = new ScannedFragments();
    ScalarVolume values = scanned(fine, grid);
    for (BitCube each : FragmentCutter.cut(solid(values), grid, fracture).bits()) {
      scan.add(each, values, new Pose());
    }
    return scan;
  }

  private void add(BitCube fragment, ScalarVolume values, Pose home) {
    VoxelGrid grid = values.grid();
    grids.add(grid);
    bits.add(fragment);
    partial.add(PartialVoxels.of(fragment, grid, values, grid, THRESHOLD, CONTRAST));
    truth.add(home);
  }

  private static ScalarVolume scanned(PosedBits fine, VoxelGrid grid) {
    ScalarVolume values = ScalarVolume.of(grid, ScalarVolume.Storage.FLOAT32);
    AffineMap toFine = fine.gridFrom(grid, new Pose());
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          values.set(i, j, k, filled(fine.bits(), toFine, i, j, k));
        }
      }
    }
    return values;
  }

  private static BitCube solid(ScalarVolume values) {
    VoxelGrid grid = values.grid();
    BitCube solid = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          if (values.value(i, j, k) >= THRESHOLD) {
            solid.set(i, j, k);
          }
        }
      }
    }
    return solid;
  }

  /** Returns the part of a voxel that a fragment fills. */
  private static double filled(BitCube fragment, AffineMap toFine, int i, int j, int k) {
    Vec3 p = new Vec3();
    int solid = 0;
    for (int c = 0; c < SAMPLES; c++) {
      for (int b = 0; b < SAMPLES; b++) {
        for (int a = 0; a < SAMPLES; a++) {
          p.set(i + (a + 0.5) / SAMPLES, j + (b + 0.5) / SAMPLES, k + (c + 0.5) / SAMPLES);
          toFine.transform(p, p);
          if (fragment.get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z))) {
            solid++;
          }
        }
      }
    }
    return solid / (double) (SAMPLES * SAMPLES * SAMPLES);
  }
}
