package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.benchmarks.stress.StressSession.Attacked;
import org.palpate.benchmarks.stress.WorkStudy;
import org.palpate.testing.Seeds;

/** Bounds the work of a frame at the default w_max, in work units that no machine changes. */
class FrameWorkTest {
  private static final int MAX_RATIO_TO_A_SLIDE = 20;

  /**
   * The same for {@code smooth}. Most of its sliding frames find all voxels in its cache, so its
   * ratios refer to the 99th percentile of a slide, a frame in which the cache moves on.
   */
  private static final int MAX_RATIO_OF_SMOOTH = 15;

  /**
   * The same for {@code smooth} and a hostile hand. Some of its scenes have long voxels, where a
   * jump interpolates columns in each window that it reads.
   */
  private static final int MAX_RATIO_OF_HOSTILE = 30;

  /**
   * The same for {@code smooth} among alternating slices of long voxels. Half of the slices are
   * empty, so that its search for an outline reads them as far as it reaches: 24 pixels to each
   * side. After a jump none of these pixels is cached, and each column is interpolated anew.
   */
  private static final int MAX_RATIO_AMONG_SLICES = 36;

  /** The same if an edit before each frame empties the cache. */
  private static final int MAX_RATIO_AMONG_EDITED_SLICES = 90;

  /**
   * The same if slices are 9 and 10 pixels apart. The longest path of a frame, three slices, is up
   * to 30 pixels there, so that windows at its two ends share no columns. With slices up to 3
   * pixels apart it is 8 or 9 pixels, less than a window is wide.
   */
  private static final int MAX_RATIO_AMONG_FAR_SLICES = 54;

  /**
   * The same if voxels are long along two axes. The search of the second cut then reads cells that
   * the first one makes.
   */
  private static final int MAX_RATIO_ALONG_TWO_AXES = 100;

  /** The same if an edit before each frame empties the cache. */
  private static final int MAX_RATIO_OF_EDITED_ALONG_TWO_AXES = 260;

  private static final int CASES = 500;
  private static final int JUMPS = 8_000;

  @ParameterizedTest
  @EnumSource
  void noFrameNeedsMuchMoreWorkThanASlidingFrame(Attacked solver) {
    List<WorkStudy.Row> rows = rows(solver);
    WorkStudy.Row slide = row(rows, WorkStudy.SLIDING);
    long sliding = solver == Attacked.SMOOTH ? slide.p99() : slide.median();
    assertTrue(sliding > 10, "the words that a frame reads are counted: " + rows);
    for (WorkStudy.Row row : rows) {
      assertTrue(
          row.worst() <= maxRatio(solver, row.hand()) * sliding,
          () -> row + " sliding " + sliding + " seed " + Seeds.seed());
    }
    System.out.println("work units of " + solver + ": " + rows);
  }

  @Test
  void theCountIsTheSameInEveryRun() {
    WorkStudy study = new WorkStudy(Attacked.GUARDED, Seeds.seed(), 5, 1000);
    assertEquals(study.rows(), study.rows());
  }

  private static int maxRatio(Attacked solver, String hand) {
    if (solver != Attacked.SMOOTH) {
      return MAX_RATIO_TO_A_SLIDE;
    }
    return switch (hand) {
      case WorkStudy.HOSTILE -> MAX_RATIO_OF_HOSTILE;
      case WorkStudy.SLICES -> MAX_RATIO_AMONG_SLICES;
      case WorkStudy.FAR_SLICES -> MAX_RATIO_AMONG_FAR_SLICES;
      case WorkStudy.EDITED_SLICES, WorkStudy.EDITED_FAR_SLICES -> MAX_RATIO_AMONG_EDITED_SLICES;
      case WorkStudy.SLICES_ALONG_TWO_AXES -> MAX_RATIO_ALONG_TWO_AXES;
      case WorkStudy.EDITED_SLICES_ALONG_TWO_AXES -> MAX_RATIO_OF_EDITED_ALONG_TWO_AXES;
      default -> MAX_RATIO_OF_SMOOTH;
    };
  }

  private static List<WorkStudy.Row> rows(Attacked solver) {
    return new WorkStudy(solver, Seeds.seed(), CASES, JUMPS).rows();
  }

  private static WorkStudy.Row row(List<WorkStudy.Row> rows, String hand) {
    return rows.stream().filter(row -> row.hand().equals(hand)).findFirst().orElseThrow();
  }
}
