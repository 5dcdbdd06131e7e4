package org.palpate.benchmarks.carve;

import java.util.List;
import java.util.function.Consumer;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.stress.FrameAttack;

/** Attacks whole frames of a point that cuts; see {@link FrameAttack#ofCuts}. */
final class PointCarveStudy {
  private static final int REPORTS = 100;

  private final FrameAttack attack = FrameAttack.ofCuts();
  private final long seed;
  private final Consumer<String> progress;

  PointCarveStudy(long seed, Consumer<String> progress) {
    this.seed = seed;
    this.progress = progress;
  }

  /** Runs the attack until the first fault or for a number of frames, and returns its figures. */
  List<RigidFigure> figures(long wanted) {
    String fault = null;
    for (int part = 1; part <= REPORTS && fault == null; part++) {
      fault = attack.untilFrames(seed, wanted * part / REPORTS);
      progress.accept(attack.frames() + " frames, " + attack.legs() + " legs, fault " + fault);
    }
    return List.of(
        new RigidFigure("attack", "point", "faults", fault == null ? 0 : 1, "", 0),
        countOf("legs judged", attack.legs()),
        countOf("frames", attack.frames()),
        countOf("voxels removed or filled", attack.changes()),
        countOf("edits, undo and redo", attack.edits()),
        countOf("points set free", attack.freed()));
  }

  private static RigidFigure countOf(String name, long count) {
    return RigidFigure.of("attack", "point", name, (double) count, "");
  }
}
