package org.palpate.benchmarks.gpu;

import java.util.SplittableRandom;
import org.palpate.body.GrownSolids;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.Phantom;

/**
 * Grows the skull of the head phantom by the clearance of a ball, on one thread of the CPU: as a
 * whole, as at the start of a session, and after edits, as in a frame.
 */
final class GrowthTimes {
  private static final double RADIUS_MM = 4;
  private static final int PLACES = 1_024;
  private static final long SEED = 1;

  private final BitCube bits;
  private final BitCube start;
  private final GridMetric metric;
  private final Clearance clearance;
  private final GrownSolids grown;

  /** Boxes around voxels of the surface. */
  private final IntBox[] places = new IntBox[PLACES];

  private int edits;

  /**
   * Grows the skull, and chooses places of edits.
   *
   * @param phantom edge of the phantom, voxels
   * @param edge edge of the boxes that are edited, voxels
   */
  GrowthTimes(int phantom, int edge) {
    SegmentedVolume head = Phantom.parse("head:" + phantom).segments();
    Segment skull = head.segments().get(0);
    VoxelGrid grid = head.grid();
    bits = skull.bits();
    start = bits.copy();
    metric = grid.metric();
    double coverMm = metric.shortestEdgeMm();
    clearance =
        Clearance.ofWholeBody(ToolSampler.ofShape(RodShape.sphere(RADIUS_MM), coverMm), grid, 0);
    grown = newGrown();
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < PLACES; ) {
      int i = random.nextInt(bits.sizeX() - edge);
      int j = random.nextInt(bits.sizeY() - edge);
      int k = random.nextInt(bits.sizeZ() - edge);
      if (bits.get(i, j, k) && !bits.isSurrounded(i, j, k)) {
        places[n] = new IntBox();
        places[n].include(i, j, k);
        places[n++].include(i + edge - 1, j + edge - 1, k + edge - 1);
      }
    }
  }

  private GrownSolids newGrown() {
    return new GrownSolids(bits, metric, clearance.growthMm(), clearance.longestCellMm());
  }

  /** Returns the number of solid voxels. */
  int voxels() {
    return (int) bits.solidCount();
  }

  /** Grows everything. */
  void growAll() {
    if (newGrown().cells().solidCount() < voxels()) {
      throw new IllegalStateException("grown solids contain the solids");
    }
  }

  /** Empties a box, or restores its voxels, and grows the solids again around it. */
  void growAfterEdit() {
    IntBox place = places[edits / 2 % PLACES];
    boolean restores = edits++ % 2 == 1;
    for (int k = place.lowZ; k <= place.highZ; k++) {
      for (int j = place.lowY; j <= place.highY; j++) {
        for (int i = place.lowX; i <= place.highX; i++) {
          if (!restores) {
            bits.clear(i, j, k);
          } else if (start.get(i, j, k)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    grown.update(place);
  }
}
