package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/**
 * Real masks of which only every second, third or fifth slice is left: the force is nearly that on
 * all slices. The device presses at random places of the surface, 2 mm deep.
 */
class ThinnedScanTest {
  private static final long SEED = 7;
  private static final int PRESSES = 2000;
  private static final int FRAMES = 40;
  private static final double DEPTH_MM = 2;
  private static final double MAX_STEP_MM = 8;

  @ParameterizedTest
  @CsvSource({
    "labels/Skull.nrrd, nonzero, 2, 1.5, 20, 95",
    "labels/Skull.nrrd, nonzero, 3, 2.5, 35, 115",
    "labels/Skull.nrrd, nonzero, 5, 4, 40, 117",
    "labels/HN-Atlas-labels.nrrd, nonzero, 2, 4, 30, 95",
    "labels/HN-Atlas-labels.nrrd, nonzero, 3, 7, 45, 122",
    "labels/HN-Atlas-labels.nrrd, nonzero, 5, 13, 60, 135",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, nonzero, 2, 1.5, 20, 105",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, nonzero, 3, 2.5, 35, 120",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, nonzero, 5, 4.5, 40, 124"
  })
  void theForceOnFewerSlicesIsNearlyThatOnAll(
      String file,
      String segment,
      int every,
      double median,
      double percentile90,
      double percentile99)
      throws IOException {
    SegmentedVolume volume =
        SegmentBuilder.read(
            VolumeFiles.open(Scans.file(file), ReadOptions.defaults()),
            List.of(SegmentSpec.parse("bone=" + segment)));
    Thinned thinned =
        new Thinned(volume.segments().get(0).bits(), volume.grid().spacingMm(), every);
    double[] angles = thinned.angles();
    Arrays.sort(angles);
    System.out.printf(
        Locale.ROOT,
        "%s, every %d: %d presses, angle %.1f, 90 %% %.1f, 99 %% %.1f degrees%n",
        file,
        every,
        angles.length,
        at(angles, 0.5),
        at(angles, 0.9),
        at(angles, 0.99));
    assertTrue(at(angles, 0.5) <= median, () -> "median " + at(angles, 0.5));
    assertTrue(at(angles, 0.9) <= percentile90, () -> "90 % " + at(angles, 0.9));
    assertTrue(at(angles, 0.99) <= percentile99, () -> "99 % " + at(angles, 0.99));
  }

  private static double at(double[] sorted, double fraction) {
    return sorted[(int) (fraction * (sorted.length - 1))];
  }

  /** A scan with all slices, and the same with some of them. */
  private static final class Thinned {
    private final BitCube all;
    private final int every;
    private final CollisionScene allScene;
    private final CollisionScene someScene;
    private final GridMetric allMetric;
    private final SmoothSolver onAll;
    private final SmoothSolver onSome;
    private final OccupancyField field;
    private final SplittableRandom random = new SplittableRandom(SEED);

    Thinned(BitCube all, Vec3 spacingMm, int every) {
      this.all = all;
      this.every = every;
      allScene = new CollisionScene(List.of(all));
      someScene = new CollisionScene(List.of(everyNth(all, every)));
      allMetric = GridMetric.of(spacingMm);
      onAll = new SmoothSolver(allMetric, MAX_STEP_MM);
      onSome =
          new SmoothSolver(
              new GridMetric(spacingMm.x, spacingMm.y, every * spacingMm.z), MAX_STEP_MM);
      field = OccupancyField.ofBits(allMetric);
      field.use(allScene);
    }

    private static BitCube everyNth(BitCube all, int every) {
      BitCube some = new BitCube(all.sizeX(), all.sizeY(), all.sizeZ() / every);
      for (int k = 0; k < some.sizeZ(); k++) {
        for (int j = 0; j < some.sizeY(); j++) {
          for (int i = 0; i < some.sizeX(); i++) {
            if (all.get(i, j, every * k + every / 2)) {
              some.set(i, j, k);
            }
          }
        }
      }
      return some;
    }

    /** Returns the angles between both forces, degrees. */
    double[] angles() {
      double[] angles = new double[PRESSES];
      Vec3 start = new Vec3();
      Vec3 device = new Vec3();
      for (int n = 0; n < PRESSES; n++) {
        do {
          choosePress(start, device);
        } while (!isPressIntoBoth(start, device));
        Vec3 force = force(onAll, allScene, start, device);
        Vec3 thinForce = force(onSome, someScene, thin(start), thin(device));
        thinForce.z *= every;
        angles[n] = AccuracyMeter.angleDegrees(toMm(thinForce), unit(toMm(force)));
      }
      return angles;
    }

    /** Chooses an empty voxel at the surface, and a device below it, grid coordinates. */
    private void choosePress(Vec3 start, Vec3 device) {
      do {
        start.set(
            random.nextInt(all.sizeX()) + 0.5,
            random.nextInt(all.sizeY()) + 0.5,
            random.nextInt(all.sizeZ()) + 0.5);
      } while (!isEmptyBesideSolid((int) start.x, (int) start.y, (int) start.z));
      FieldSample sample = field.evaluate(new SeedCell().set(start), start);
      Vec3 normal = sample.hasNormal() ? sample.normal() : new Vec3();
      device.set(
          start.x - DEPTH_MM * normal.x / allMetric.spacingX(),
          start.y - DEPTH_MM * normal.y / allMetric.spacingY(),
          start.z - DEPTH_MM * normal.z / allMetric.spacingZ());
    }

    private boolean isEmptyBesideSolid(int i, int j, int k) {
      return !all.get(i, j, k)
          && (all.get(i - 1, j, k)
              || all.get(i + 1, j, k)
              || all.get(i, j - 1, k)
              || all.get(i, j + 1, k)
              || all.get(i, j, k - 1)
              || all.get(i, j, k + 1));
    }

    private boolean isPressIntoBoth(Vec3 start, Vec3 device) {
      Vec3 thinStart = thin(start);
      return isSolid(allScene, device)
          && isSolid(someScene, thin(device))
          && !someScene.touches(thinStart.x, thinStart.y, thinStart.z);
    }

    private static boolean isSolid(CollisionScene scene, Vec3 at) {
      return scene.isSolid((int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z));
    }

    /** Returns a position in the grid of fewer slices; the middles of the slices left agree. */
    private Vec3 thin(Vec3 position) {
      int firstLeft = every / 2;
      double slice = (position.z - (firstLeft + 0.5)) / every + 0.5;
      return new Vec3(position.x, position.y, slice);
    }

    private static Vec3 force(SmoothSolver solver, CollisionScene scene, Vec3 start, Vec3 device) {
      InteractionPoint point = new InteractionPoint();
      point.position.set(start);
      solver.reset();
      for (int frame = 0; frame < FRAMES; frame++) {
        solver.follow(scene, device, point);
      }
      return point.position.sub(device, new Vec3());
    }

    private Vec3 toMm(Vec3 grid) {
      return new Vec3(
          grid.x * allMetric.spacingX(),
          grid.y * allMetric.spacingY(),
          grid.z * allMetric.spacingZ());
    }

    private static Vec3 unit(Vec3 vector) {
      return vector.mul(1 / vector.length(), new Vec3());
    }
  }
}
