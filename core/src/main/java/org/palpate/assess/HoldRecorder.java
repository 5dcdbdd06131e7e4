package org.palpate.assess;

import java.util.ArrayList;
import java.util.List;
import org.palpate.frame.FrameRecord;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/** Records each hold: which body the hand held, when, and how far it moved the body. One thread. */
final class HoldRecorder {
  private static final int NO_BODY = -1;

  private final List<Hold> holds = new ArrayList<>();
  private final Pose first = new Pose();
  private final Pose last = new Pose();
  private final Vec3 moved = new Vec3();
  private final Vec3 turned = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private int held = NO_BODY;
  private double fromSeconds;
  private double toSeconds;

  /** Adds a frame. */
  void add(FrameRecord frame, double atSeconds) {
    if (frame.heldBody != held) {
      end();
      held = frame.heldBody;
      fromSeconds = atSeconds;
      first.set(frame.tool);
    }
    toSeconds = atSeconds;
    last.set(frame.tool);
  }

  /** Ends the present hold, if there is one. */
  void end() {
    if (held != NO_BODY) {
      first.differenceTo(last, moved, turned, scratch);
      holds.add(new Hold(held, fromSeconds, toSeconds, moved.length(), turned.length()));
      held = NO_BODY;
    }
  }

  /** Returns the holds that have ended, in their order. */
  List<Hold> holds() {
    return List.copyOf(holds);
  }
}
