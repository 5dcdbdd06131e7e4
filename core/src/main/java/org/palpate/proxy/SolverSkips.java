package org.palpate.proxy;

/**
 * What a solver may skip; answers are the same either way, but that without {@code climbs} none
 * waits. All of it, unless a measurement is to show what one is worth.
 *
 * @param emptyBricks whether rays pass empty bricks in one step
 * @param neighbours whether neighbourhoods are kept from frame to frame
 * @param climbs whether climbs that were in vain are remembered
 * @param rest whether a frame in which device and point rest is left out
 */
public record SolverSkips(boolean emptyBricks, boolean neighbours, boolean climbs, boolean rest) {
  /** All of it. */
  public static final SolverSkips ALL = new SolverSkips(true, true, true, true);
}
