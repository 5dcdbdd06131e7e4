package org.palpate.body;

/** How a body came to a pose in a session. */
public enum BodyEvent {
  /** It approached a goal. */
  MOVED,

  /** The hand took hold of it where it was. */
  TAKEN,

  /** The hand moved it. */
  HELD,

  /** The hand let go of it where it was. */
  RELEASED,

  /** Undo or redo put it there, without a motion. */
  PLACED
}
