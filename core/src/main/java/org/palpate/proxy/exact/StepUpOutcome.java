package org.palpate.proxy.exact;

/** The outcome of an attempt to step up. */
enum StepUpOutcome {
  /** The proxy is nearer to the device, and the frame goes on. */
  NEARER,
  /** The proxy is nearer to the device, and the path of this frame is used up. */
  NEARER_OUT_OF_PATH,
  /** No step up leads nearer to the device; the proxy stays where it is. */
  NOT_NEARER,
  /** The remaining path is too short to decide; the proxy stays where it is. */
  PATH_TOO_SHORT,
  /** The search was skipped because it is known to fail; the proxy stays where it is. */
  SKIPPED;

  /** Whether the proxy came nearer to the device. */
  boolean isNearer() {
    return this == NEARER || this == NEARER_OUT_OF_PATH;
  }
}
