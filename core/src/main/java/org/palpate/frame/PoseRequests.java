package org.palpate.frame;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.palpate.geometry.Pose;
import org.palpate.rigid.BodyMover;

/**
 * The poses to which bodies are asked to move. For each body the last request counts, until a frame
 * takes it.
 *
 * <p>Any thread requests. The haptic thread takes the requests, and allocates nothing.
 */
final class PoseRequests {
  /** For each body the pose that was requested last, until a frame takes it; else null. */
  private final AtomicReferenceArray<Pose> latest;

  PoseRequests(int bodies) {
    latest = new AtomicReferenceArray<>(bodies);
  }

  /** Requests a pose of a body; copies it. Any thread. */
  void request(int body, Pose restToPresent) {
    latest.set(body, new Pose().set(restToPresent));
  }

  /** Makes the requested poses the goals of bodies, unless the hand moves them. Haptic thread. */
  void apply(Grasp grasp, BodyMover bodies) {
    for (int n = 0; n < latest.length(); n++) {
      if (latest.get(n) != null) {
        Pose goal = latest.getAndSet(n, null);
        if (!grasp.moves(n)) {
          bodies.setGoal(n, goal);
        }
      }
    }
  }
}
