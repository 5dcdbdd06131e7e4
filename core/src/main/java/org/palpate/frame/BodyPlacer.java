package org.palpate.frame;

import org.palpate.body.BodyScene;
import org.palpate.edit.PlacementLog;
import org.palpate.geometry.Pose;
import org.palpate.rigid.BodyMover;

/** Puts the bodies of a scene where they were. Haptic thread only; allocates nothing. */
record BodyPlacer(BodyScene bodies, BodyMover mover) implements PlacementLog.Placer {
  @Override
  public int count() {
    return bodies.count();
  }

  @Override
  public Pose pose(int body) {
    return bodies.body(body).pose();
  }

  @Override
  public boolean keepsClear(int body, Pose pose, int other) {
    return mover.keepsClear(body, pose, other);
  }

  @Override
  public void place(int body, Pose pose) {
    bodies.body(body).setPose(pose);
  }
}
