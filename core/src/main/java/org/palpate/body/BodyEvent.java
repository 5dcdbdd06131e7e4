package org.palpate.body;

/** The cause of a body's pose in a session. */
public enum BodyEvent {
  /** It approached a goal. */
  MOVED,

  /** The hand took hold of it where it was. */
  TAKEN,

  /** It moves along with the body that was taken, as if glued to it. */
  JOINED,

  /** The hand moved it. */
  HELD,

  /** The hand let go of it, and of all that joined, where they were. */
  RELEASED,

  /** Undo or redo put it there, without a motion. */
  PLACED
}
