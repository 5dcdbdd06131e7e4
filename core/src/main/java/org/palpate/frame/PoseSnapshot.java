package org.palpate.frame;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;

/**
 * The poses of all bodies at the end of a frame, to the bit, for another thread. Frames copy them
 * only after they were requested.
 *
 * <p>One thread requests and reads. The haptic thread copies; it allocates nothing and never waits.
 */
public final class PoseSnapshot {
  private final BodyScene bodies;

  /** The haptic thread writes them while they are requested; the other thread reads them else. */
  private final List<Pose> poses = new ArrayList<>();

  private volatile boolean requested;

  /** Creates a snapshot of the poses that bodies have now. */
  PoseSnapshot(BodyScene bodies) {
    this.bodies = bodies;
    for (int n = 0; n < bodies.count(); n++) {
      poses.add(new Pose().set(bodies.body(n).pose()));
    }
  }

  /** Requests the poses at the end of the next frame. */
  public void request() {
    requested = true;
  }

  /**
   * {@return whether no request is left: a frame has copied the poses since the last one, if any}
   */
  public boolean isReady() {
    return !requested;
  }

  /**
   * {@return the pose of each body, from rest to present, world mm; new poses} Call it only if
   * {@link #isReady}.
   */
  public List<Pose> poses() {
    List<Pose> copies = new ArrayList<>();
    for (Pose pose : poses) {
      copies.add(new Pose().set(pose));
    }
    return copies;
  }

  /** Copies the poses if they are requested. Haptic thread, at the end of a frame. */
  void copyIfRequested() {
    if (requested) {
      for (int n = 0; n < poses.size(); n++) {
        poses.get(n).set(bodies.body(n).pose());
      }
      requested = false;
    }
  }
}
