package org.palpate.proxy.exact;

/**
 * What a solver may skip; answers are the same either way, but that without {@code climbs} none
 * waits. All of it, unless a measurement is to show what one is worth.
 *
 * @param emptyBricks whether rays pass empty bricks in one step
 * @param neighbours whether neighbourhoods are kept from frame to frame
 * @param climbs whether climbs that were in vain are remembered
 * @param rest whether a frame in which device and point rest is left out
 */
public record SkipOptions(boolean emptyBricks, boolean neighbours, boolean climbs, boolean rest) {
  /** All of it. */
  public static final SkipOptions ALL = new SkipOptions(true, true, true, true);
}
