package org.palpate.proxy.exact;

/** The outcome of a slide of the proxy towards the device. */
enum SlideOutcome {
  /** The proxy came nearer to the device, and another slide may do so again. */
  NEARER,
  /** No further slide comes nearer to the device. */
  STUCK,
  /** The path of this frame is used up, or its legs are. */
  OUT_OF_PATH
}
