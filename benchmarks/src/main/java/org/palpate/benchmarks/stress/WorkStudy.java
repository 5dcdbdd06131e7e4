package org.palpate.benchmarks.stress;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactSettings;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Measures the work of a frame at the default w_max, in the units of {@link WorkCounts}. Hands
 * slide, jump 5 to 50 voxels, are hostile in hostile scenes, or jump among alternating slices.
 */
public final class WorkStudy {
  /** The slide to compare with: a sphere, 5 voxels deep, 2 voxels per frame. */
  public static final String SLIDING = "slide, 2 voxels a frame";

  /** The name of hostile hands in hostile scenes. */
  public static final String HOSTILE = "hostile";

  /** The name of hands that jump among alternating slices of long voxels. */
  public static final String SLICES = "jumps, alternating slices";

  /** The name of hands that jump among such slices while a voxel is edited before each frame. */
  public static final String EDITED_SLICES = "jumps and edits, alternating slices";

  /** The name of hands that jump among alternating slices of very long voxels. */
  public static final String FAR_SLICES = SLICES + ", 9 and 10 pixels apart";

  /** The name of hands that jump among such slices with edits. */
  public static final String EDITED_FAR_SLICES = EDITED_SLICES + ", 9 and 10 pixels apart";

  /** The name of hands that jump among alternating slices of voxels with two long axes. */
  public static final String SLICES_ALONG_TWO_AXES = SLICES + ", two long axes";

  /** The name of hands that jump among such slices with edits. */
  public static final String EDITED_SLICES_ALONG_TWO_AXES = EDITED_SLICES + ", two long axes";

  private static final double DEPTH_VOXELS = 5;
  private static final int SLIDE_FRAMES = 5000;
  private static final String SLID_ON = "sphere:192";

  /** The edges of the voxels of alternating slices; the shortest is 1. */
  private static final List<Vec3> ONE_LONG_AXIS =
      List.of(new Vec3(1, 1, 1.5), new Vec3(1, 1, 2), new Vec3(1, 1, 3), new Vec3(1, 1, 5));

  /** The same for voxels that are cut into cells longer than their pixels. */
  private static final List<Vec3> ONE_VERY_LONG_AXIS =
      List.of(new Vec3(1, 1, 9), new Vec3(1, 1, 10));

  private static final List<Vec3> TWO_LONG_AXES =
      List.of(new Vec3(1, 2, 2), new Vec3(1, 3, 5), new Vec3(1, 5, 2));

  private static final int SLICES_EDGE = 160;

  private final StressSession.Attacked attacked;
  private final long seed;
  private final int cases;
  private final int jumps;

  /**
   * Creates a study.
   *
   * @param attacked the solver
   * @param cases the number of hostile scenes, of 1,000 frames each
   * @param jumps the number of jumps in each of several phantoms
   */
  public WorkStudy(StressSession.Attacked attacked, long seed, int cases, int jumps) {
    this.attacked = attacked;
    this.seed = seed;
    this.cases = cases;
    this.jumps = jumps;
  }

  /**
   * The work of frames of one kind.
   *
   * @param hand the motion of the hand
   * @param frames the number of frames
   * @param median the median work of a frame
   * @param p99 the 99th percentile
   * @param p999 the 99.9th percentile
   * @param worst the largest work of a frame
   * @param mostWindows the most windows that a frame of {@code smooth} read; 0 for other solvers
   */
  public record Row(
      String hand, int frames, long median, long p99, long p999, long worst, int mostWindows) {
    /** Returns the cells of its row in {@code steps-SOLVER-SEED.csv}. */
    List<Object> cells() {
      return List.of(hand, frames, median, p99, worst);
    }

    static Row of(String hand, List<WorkCounts.Result> parts) {
      long[] sorted = parts.stream().flatMapToLong(part -> Arrays.stream(part.counts())).toArray();
      Arrays.sort(sorted);
      int last = sorted.length - 1;
      return new Row(
          hand,
          sorted.length,
          sorted[last / 2],
          sorted[(int) (last * 0.99)],
          sorted[(int) (last * 0.999)],
          sorted[last],
          parts.stream().mapToInt(WorkCounts.Result::mostWindows).max().orElseThrow());
    }
  }

  /** Measures all rows. */
  public List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    rows.add(slide("slide, 0.05 voxel a frame", 0.05));
    rows.add(slide("slide, 0.3 voxel a frame", 0.3));
    rows.add(slide(SLIDING, 2));
    for (String phantom : List.of("sphere:128", "maze:64", "head:128", "shell:96")) {
      BitCube bits = Phantom.parse(phantom).segments().segments().get(0).bits();
      Trajectory trajectory =
          Trajectories.jumps(bits.sizeX(), bits.sizeY(), bits.sizeZ(), jumps, seed);
      rows.add(Row.of("jumps, " + phantom, List.of(follow(bits, trajectory))));
    }
    rows.add(hostile());
    rows.add(slices(SLICES, ONE_LONG_AXIS, false));
    rows.add(slices(EDITED_SLICES, ONE_LONG_AXIS, true));
    rows.add(slices(FAR_SLICES, ONE_VERY_LONG_AXIS, false));
    rows.add(slices(EDITED_FAR_SLICES, ONE_VERY_LONG_AXIS, true));
    rows.add(slices(SLICES_ALONG_TWO_AXES, TWO_LONG_AXES, false));
    rows.add(slices(EDITED_SLICES_ALONG_TWO_AXES, TWO_LONG_AXES, true));
    return rows;
  }

  private Row slide(String name, double speed) {
    Phantom phantom = Phantom.parse(SLID_ON);
    Trajectory slide =
        Trajectories.slide(
            phantom.analyticSurface().orElseThrow(),
            phantom.edge(),
            DEPTH_VOXELS,
            speed,
            SLIDE_FRAMES,
            seed);
    return Row.of(name, List.of(follow(phantom.segments().segments().get(0).bits(), slide)));
  }

  private WorkCounts.Result follow(BitCube bits, Trajectory trajectory) {
    GridMetric unit = new GridMetric(1, 1, 1);
    Vec3 device = trajectory.position(0, new Vec3());
    Vec3 start = new Vec3().set(device);
    CollisionScene scene = new CollisionScene(List.of(bits));
    if (scene.touches(start.x, start.y, start.z)) {
      new NearestFreeVoxel(unit).find(scene, start, start);
    }
    WorkCounts counts =
        new WorkCounts(
            attacked, bits, unit, ContactSettings.defaultMaxStepMm(new Vec3(1, 1, 1)), start);
    for (int frame = 0; frame < trajectory.size(); frame++) {
      counts.follow(trajectory.position(frame, device));
    }
    return counts.result();
  }

  private Row hostile() {
    List<WorkCounts.Result> all = new ArrayList<>();
    for (int number = 0; number < cases; number++) {
      StressCase stress = new StressCase(StressRun.caseSeed(seed, number));
      double maxStepMm = ContactSettings.defaultMaxStepMm(stress.scene.spacingMm());
      WorkCounts counts =
          new WorkCounts(
              attacked, stress.scene.bits(), stress.scene.metric(), maxStepMm, stress.start);
      Vec3 device = new Vec3().set(stress.start);
      for (int frame = 0; frame < StressCase.FRAMES; frame++) {
        stress.next(frame, counts.position(), device);
        counts.follow(device);
      }
      all.add(counts.result());
    }
    return Row.of(HOSTILE, all);
  }

  /**
   * Follows hands that jump among slices of which every other one is solid but for single holes.
   * Outlines are then far apart, so that the search for them reads most.
   */
  private Row slices(String name, List<Vec3> spacings, boolean edited) {
    int frames = jumps / spacings.size();
    List<WorkCounts.Result> all = new ArrayList<>();
    for (Vec3 edges : spacings) {
      all.add(jumpAmongSlices(edges, frames, edited));
    }
    return Row.of(name, all);
  }

  private WorkCounts.Result jumpAmongSlices(Vec3 edges, int frames, boolean edited) {
    SplittableRandom random = new SplittableRandom(seed);
    int rows = (int) (SLICES_EDGE / edges.y);
    BitCube bits = new BitCube(SLICES_EDGE, rows, (int) (SLICES_EDGE / edges.z));
    for (int k = 0; k < bits.sizeZ(); k += 2) {
      for (int n = 0; n < SLICES_EDGE * rows; n++) {
        if (random.nextInt(16) != 0) {
          bits.set(n % SLICES_EDGE, n / SLICES_EDGE, k);
        }
      }
    }
    double maxStepMm = ContactSettings.defaultMaxStepMm(edges);
    Vec3 device = new Vec3(-5, -5, -5);
    WorkCounts counts =
        new WorkCounts(attacked, bits, GridMetric.of(edges), maxStepMm, new Vec3().set(device));
    for (int frame = 0; frame < frames; frame++) {
      boolean jumps = frame % 3 == 0; // in between the point catches up
      for (int axis = 0; axis < 3; axis++) {
        double edge = SLICES_EDGE / edges.get(axis);
        double at = device.get(axis) + (4 * random.nextDouble() - 2) / edges.get(axis);
        device.set(axis, jumps ? edge * random.nextDouble() : at);
      }
      if (edited) {
        counts.clear(
            random.nextInt(SLICES_EDGE), random.nextInt(rows), random.nextInt(bits.sizeZ()));
      }
      counts.follow(device);
    }
    return counts.result();
  }
}
