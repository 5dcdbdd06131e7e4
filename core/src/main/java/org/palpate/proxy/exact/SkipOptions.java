package org.palpate.proxy.exact;

/**
 * The work that a guarded solver may skip. The proxy ends at the same bits either way, except that
 * without {@code failedSteps} no step up waits, see {@link FailedStepCache}.
 *
 * @param neighbourhoods whether neighbourhoods are kept from frame to frame
 * @param failedSteps whether searches for a step up that failed are remembered
 * @param rest whether a frame is left out in which the device and the proxy are at rest
 */
record SkipOptions(boolean neighbourhoods, boolean failedSteps, boolean rest) {
  /** Everything may be skipped, as in production. */
  static final SkipOptions ALL = new SkipOptions(true, true, true);
}
