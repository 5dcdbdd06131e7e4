package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.benchmarks.stress.StressSession.Attacked;
import org.palpate.benchmarks.stress.WorkStudy;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.testing.Seeds;

/**
 * Bounds the work of a frame at the default w_max, in work units that no machine changes, for
 * several seeds.
 *
 * <p>A frame of {@code smooth} reads a bounded number of windows by design, whatever the seed. What
 * a window costs depends on the scene: among alternating slices nearly each of its columns is
 * interpolated. So the windows of each frame are bounded, and the work of all but the slowest
 * thousandth. On cubes the work of each frame is bounded too.
 */
class FrameWorkTest {
  /** The bound on each frame of {@code guarded}, in medians of its slide. */
  private static final int MAX_RATIO_TO_A_SLIDE = 20;

  /** The bound on each frame of {@code smooth} on cubes, in 99th percentiles of its slide. */
  private static final int MAX_RATIO_OF_THE_WORST_ON_CUBES = 15;

  /** The bound on the 99.9th percentile of {@code smooth} on cubes, in medians of its slide. */
  private static final int MAX_RATIO_ON_CUBES = 15;

  /**
   * The same for a hostile hand. Most sliding frames of {@code smooth} find all voxels in its
   * cache, so this ratio and those below refer to the 99th percentile of a slide, a frame in which
   * the cache moves on. That takes 52 units; while it took 76, the ratios were smaller in
   * proportion. Some hostile scenes have long voxels.
   */
  private static final int MAX_RATIO_OF_HOSTILE = 8;

  /**
   * The same among alternating slices of long voxels. Half of the slices are empty, so that the
   * search for an outline reads them as far as it reaches: 24 pixels to each side. After a jump
   * none of these pixels is cached, and each column is interpolated anew.
   */
  private static final int MAX_RATIO_AMONG_SLICES = 56;

  /** The same if a voxel is edited before each frame, which empties the cache around it. */
  private static final int MAX_RATIO_AMONG_EDITED_SLICES = 84;

  /**
   * The same if slices are 9 and 10 pixels apart. The longest path of a frame, three slices, is up
   * to 30 pixels there, so that windows at its two ends share no columns. With slices up to 3
   * pixels apart it is 8 or 9 pixels, less than a window is wide.
   */
  private static final int MAX_RATIO_AMONG_FAR_SLICES = 84;

  /** The same with edits. */
  private static final int MAX_RATIO_AMONG_EDITED_FAR_SLICES = 112;

  /**
   * The same if voxels are long along two axes. The search of the second cut then reads cells that
   * the first one makes.
   */
  private static final int MAX_RATIO_ALONG_TWO_AXES = 112;

  /** The same with edits. */
  private static final int MAX_RATIO_OF_EDITED_ALONG_TWO_AXES = 168;

  /** The hands that meet long voxels, at least in some scenes. */
  private static final Set<String> ON_LONG_VOXELS =
      Set.of(
          WorkStudy.HOSTILE,
          WorkStudy.SLICES,
          WorkStudy.EDITED_SLICES,
          WorkStudy.FAR_SLICES,
          WorkStudy.EDITED_FAR_SLICES,
          WorkStudy.SLICES_ALONG_TWO_AXES,
          WorkStudy.EDITED_SLICES_ALONG_TWO_AXES);

  private static final int CASES = 200;
  private static final int JUMPS = 8_000;

  private static LongStream seeds() {
    return LongStream.of(Seeds.seed(), 1, 7);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void noFrameOfGuardedNeedsMuchMoreWorkThanASlidingFrame(long seed) {
    List<WorkStudy.Row> rows = rows(Attacked.GUARDED, seed);
    long sliding = slide(rows).median();
    assertTrue(sliding > 10, "the words that a frame reads are counted: " + rows);
    for (WorkStudy.Row row : rows) {
      assertTrue(row.worst() <= MAX_RATIO_TO_A_SLIDE * sliding, () -> row + " seed " + seed);
    }
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void framesOfSmoothReadFewWindowsAndTheSlowestOnesAreBounded(long seed) {
    List<WorkStudy.Row> rows = rows(Attacked.SMOOTH, seed);
    WorkStudy.Row slide = slide(rows);
    assertTrue(slide.median() > 10, "the words that a frame reads are counted: " + rows);
    for (WorkStudy.Row row : rows) {
      assertTrue(row.mostWindows() > 0, "windows are counted: " + row);
      assertTrue(row.mostWindows() <= SmoothSolver.MOST_WINDOWS, () -> row + " seed " + seed);
      assertTrue(row.p999() <= most(row.hand(), slide), () -> row + " seed " + seed);
      assertTrue(
          ON_LONG_VOXELS.contains(row.hand())
              || row.worst() <= MAX_RATIO_OF_THE_WORST_ON_CUBES * slide.p99(),
          () -> row + " seed " + seed);
    }
    System.out.println("work units of smooth, seed " + seed + ": " + rows);
  }

  @Test
  void theCountIsTheSameInEveryRun() {
    WorkStudy study = new WorkStudy(Attacked.GUARDED, Seeds.seed(), 5, 1000);
    assertEquals(study.rows(), study.rows());
  }

  /** Returns the most work of all but a thousandth of the frames of a hand. */
  private static long most(String hand, WorkStudy.Row slide) {
    return switch (hand) {
      case WorkStudy.HOSTILE -> MAX_RATIO_OF_HOSTILE * slide.p99();
      case WorkStudy.SLICES -> MAX_RATIO_AMONG_SLICES * slide.p99();
      case WorkStudy.EDITED_SLICES -> MAX_RATIO_AMONG_EDITED_SLICES * slide.p99();
      case WorkStudy.FAR_SLICES -> MAX_RATIO_AMONG_FAR_SLICES * slide.p99();
      case WorkStudy.EDITED_FAR_SLICES -> MAX_RATIO_AMONG_EDITED_FAR_SLICES * slide.p99();
      case WorkStudy.SLICES_ALONG_TWO_AXES -> MAX_RATIO_ALONG_TWO_AXES * slide.p99();
      case WorkStudy.EDITED_SLICES_ALONG_TWO_AXES ->
          MAX_RATIO_OF_EDITED_ALONG_TWO_AXES * slide.p99();
      default -> MAX_RATIO_ON_CUBES * slide.median();
    };
  }

  private static List<WorkStudy.Row> rows(Attacked solver, long seed) {
    return new WorkStudy(solver, seed, CASES, JUMPS).rows();
  }

  private static WorkStudy.Row slide(List<WorkStudy.Row> rows) {
    return rows.stream()
        .filter(row -> row.hand().equals(WorkStudy.SLIDING))
        .findFirst()
        .orElseThrow();
  }
}
