package org.palpate.proxy.exact;

/** The state of the position on top of a step beside the proxy. */
enum StepTop {
  /** The proxy can go there in one leg. */
  REACHABLE,
  /**
   * There is no step, the leg to its top is blocked, or no position on top is nearer to the device.
   */
  NONE,
  /** The remaining path of this frame is too short for the leg. */
  TOO_FAR
}
