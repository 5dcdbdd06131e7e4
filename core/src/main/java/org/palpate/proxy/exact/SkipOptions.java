package org.palpate.proxy.exact;

/**
 * The work that a guarded solver may skip. Skips do not change where the proxy ends, to the bit.
 * The one exception is {@code failedSteps}: it can delay a step up by some frames, as {@link
 * FailedStepCache} explains.
 *
 * @param neighbourhoods whether neighbourhoods are kept from frame to frame
 * @param failedSteps whether searches for a step up that failed are remembered
 * @param rest whether a frame is left out in which the device and the proxy are at rest
 */
record SkipOptions(boolean neighbourhoods, boolean failedSteps, boolean rest) {
  /** Everything may be skipped, as in production. */
  static final SkipOptions ALL = new SkipOptions(true, true, true);
}
