package org.palpate.benchmarks.speed;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.ManyObjectsBenchmark;
import org.palpate.benchmarks.PointShellBenchmark;
import org.palpate.benchmarks.RayCastBenchmark;
import org.palpate.benchmarks.ResponseBenchmark;
import org.palpate.benchmarks.ScaleBenchmark;
import org.palpate.benchmarks.SkipBenchmark;
import org.palpate.benchmarks.Table1Benchmark;
import org.palpate.benchmarks.VolumeBenchmark;
import org.palpate.benchmarks.VolumeReadBenchmark;
import org.palpate.benchmarks.WholeFrameBenchmark;
import org.palpate.benchmarks.report.StudyTable;

/** Studies of speed with their benchmarks. */
public enum SpeedStudy {
  /** Collision, response, whole frame, points, objects, volumes. */
  ALL(StudyTable.SPEED) {
    @Override
    List<Subject> subjects(boolean quick) {
      List<Subject> subjects = new ArrayList<>(List.of(collision(quick)));
      subjects.addAll(response(quick));
      subjects.add(
          Subject.frame("frame", WholeFrameBenchmark.class, "run")
              .with("frameOf", "bare", "recorded and shown"));
      subjects.addAll(points(quick));
      subjects.add(objects());
      subjects.addAll(volumes(quick));
      return subjects;
    }
  },

  /** The paper's Table 1 on scans. */
  TABLE1(StudyTable.TABLE1) {
    @Override
    List<Subject> subjects(boolean quick) {
      String[] scans = {
        "CThead 256x256x113", "CThead to 532x532x464", "LIDC 512x512x275", "LIDC to 512x512x520"
      };
      return List.of(
          Subject.frame("table1", Table1Benchmark.class, "wander")
              .with("data", scans)
              .with("solver", "none", "guarded", "smooth", "twin")
              .withHeap(3072));
    }
  },

  /** The gain of each skip. */
  SKIPS(StudyTable.SKIPS) {
    @Override
    List<Subject> subjects(boolean quick) {
      return List.of(
          Subject.frame("skips", SkipBenchmark.class, "frames")
              .with(
                  "skip",
                  "empty bricks",
                  "neighbours",
                  "climbs",
                  "rest",
                  "response",
                  "friction",
                  "properties")
              .with("scene", "helps", "does not help")
              .with("way", "with", "without"),
          objects());
    }
  },

  /** The same hand in grids of growing size. */
  SCALE(StudyTable.SCALE) {
    @Override
    List<Subject> subjects(boolean quick) {
      String[] edges =
          quick ? new String[] {"256", "2048"} : new String[] {"256", "512", "1024", "2048"};
      Subject frames = Subject.frame("scale", ScaleBenchmark.class, "follow").withHeap(HUGE_HEAP);
      List<Subject> subjects = new ArrayList<>();
      subjects.add(frames.with("hand", "voxels", "scaled", "cold").with("edge", edges));
      if (!quick) {
        subjects.add(frames.with("hand", "voxels", "cold").with("edge", "4096"));
      }
      return subjects;
    }
  };

  /** The bits of 4096^3 voxels take 8.1 GB. */
  private static final int HUGE_HEAP = 10_240;

  private final StudyTable table;

  SpeedStudy(StudyTable table) {
    this.table = table;
  }

  /** Returns its table. */
  StudyTable table() {
    return table;
  }

  /** Returns the name of its files without extension. */
  String fileStem() {
    return table.fileName().replace(".csv", "");
  }

  /** Returns the expected duration, s. */
  public double expectedSeconds(boolean quick) {
    return SpeedRunner.expectedSeconds(subjects(quick), quick);
  }

  /** Returns the benchmarks with their parameters. */
  abstract List<Subject> subjects(boolean quick);

  private static Subject collision(boolean quick) {
    Subject rays = Subject.frame("collision", RayCastBenchmark.class, "cast");
    return quick
        ? rays.with("place", "free", "near", "hit")
            .with("length", "4", "50")
            .with("caster", "exact", "plain:1", "sampled:1")
        : rays.with("place", "free", "near", "hit", "anywhere", "slide")
            .with("length", "1", "4", "16", "50")
            .with("caster", "exact", "plain:1", "sampled:1", "sampled:0.1", "gridplanes");
  }

  private static List<Subject> response(boolean quick) {
    Subject frames =
        Subject.frame("response", ResponseBenchmark.class, "pressAndSlide").with("depth", "5");
    String[] solvers = {"twin", "guarded", "smooth", "paper", "dot", "none"};
    if (quick) {
      return List.of(
          frames
              .with("scene", "sphere:256")
              .with("motion", "slide", "jump")
              .with("speed", "0.05")
              .with("solver", solvers));
    }
    return List.of(
        frames
            .with("scene", "sphere:256", "plane:256", "torus:256")
            .with("motion", "slide")
            .with("speed", "0.05", "0.3", "2")
            .with("solver", solvers),
        frames
            .with("scene", "sphere:256")
            .with("motion", "press", "groove", "jump", "free")
            .with("speed", "0.3")
            .with("solver", solvers));
  }

  private static List<Subject> points(boolean quick) {
    String[] threads = quick ? new String[] {"1"} : new String[] {"1", "2"};
    Subject shell = Subject.other("points", PointShellBenchmark.class, "collision");
    return List.of(
        shell.with("points", "20000").with("threads", threads),
        Subject.other("points", PointShellBenchmark.class, "response")
            .with("points", "3000")
            .with("threads", threads));
  }

  private static Subject objects() {
    return Subject.frame("objects", ManyObjectsBenchmark.class, "slide")
        .with("candidates", "tree", "each")
        .with("objects", "5", "1000")
        .withHeap(2048);
  }

  private static List<Subject> volumes(boolean quick) {
    List<Subject> subjects = new ArrayList<>();
    for (String method : List.of("readVoxel", "readWindow", "editVoxelTwice")) {
      subjects.add(Subject.frame("volume", VolumeBenchmark.class, method));
    }
    for (String method : List.of("bytesAlone", "segmentByThreshold")) {
      Subject build = Subject.other("volume", VolumeReadBenchmark.class, method);
      subjects.add(quick ? build.with("format", "nii") : build.with("format", "nii", "nii.gz"));
    }
    return subjects;
  }
}
