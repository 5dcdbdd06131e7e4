package org.palpate.frame;

import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.edit.ChangeLog.Answer;
import org.palpate.edit.PlacementLog;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.Pose;
import org.palpate.rigid.BodyMover.ClearCheck;

/** Puts the bodies of a scene where they were. Haptic thread only; allocates nothing. */
record BodyPlacer(BodyScene bodies, ClearCheck check) implements PlacementLog.Placer {
  /** Lets edits add no voxels to bodies that move: their sample points cover those at the start. */
  static void limitMovable(BodyScene bodies, VoxelWriter voxels) {
    for (int n = 0; n < bodies.count(); n++) {
      if (bodies.body(n).mobility() == Mobility.MOVABLE) {
        voxels.limit(n, bodies.body(n).bits().copy());
      }
    }
  }

  @Override
  public int count() {
    return bodies.count();
  }

  @Override
  public Pose pose(int body) {
    return bodies.body(body).pose();
  }

  @Override
  public long motions(int body) {
    return bodies.body(body).motions();
  }

  @Override
  public long edits() {
    return bodies.edits();
  }

  @Override
  public boolean isNear(int body, Pose pose, int other) {
    return check.isNear(body, pose, other);
  }

  @Override
  public void beginCheck(int body, Pose pose, int other) {
    check.begin(body, pose, other);
  }

  @Override
  public int continueCheck(int most) {
    return check.goOn(most);
  }

  @Override
  public Answer checked() {
    return switch (check.answer()) {
      case UNDECIDED -> Answer.LATER;
      case CLEAR -> Answer.YES;
      case BLOCKED -> Answer.NO;
    };
  }

  @Override
  public void place(int body, Pose pose) {
    bodies.body(body).setPose(pose);
  }
}
