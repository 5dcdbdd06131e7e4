package org.palpate.frame;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyListener;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;

/** Reports new poses of bodies to a listener. Haptic thread; a report allocates nothing. */
final class BodyReport {
  private final BodyScene bodies;
  private final Grasp grasp;

  /** The poses that the listener knows. */
  private final List<Pose> known = new ArrayList<>();

  private BodyListener listener = BodyListener.NONE;

  BodyReport(BodyScene bodies, Grasp grasp) {
    this.bodies = bodies;
    this.grasp = grasp;
    for (int n = 0; n < bodies.count(); n++) {
      known.add(new Pose().set(bodies.body(n).pose()));
    }
  }

  /** Sets who receives the reports. */
  void listen(BodyListener newListener) {
    listener = newListener;
  }

  /** Reports an event of a body. */
  void report(int body, BodyEvent event) {
    listener.accept(body, event, bodies.body(body).pose(), grasp.inHand());
  }

  /**
   * Reports the poses that changed. The cause is the hand for the bodies that it moves, and the
   * given event for the others.
   */
  void reportMotions(BodyEvent event) {
    for (int n = 0; n < known.size(); n++) {
      Pose pose = bodies.body(n).pose();
      if (!pose.sameBits(known.get(n))) {
        known.get(n).set(pose);
        report(n, grasp.moves(n) ? BodyEvent.HELD : event);
      }
    }
  }
}
