package org.palpate.statistics;

import java.util.Locale;

/** The kinds of work that a frame can skip without changing its answer. */
public enum SkipKind {
  /** Empty bricks, blocks of bricks and boxes inside a brick that a ray passed in one step. */
  EMPTY_BRICKS,
  /** Rays that lie wholly beside the box of all solids. */
  BESIDE_BOUNDS,
  /** Objects that were left out because their bounds are far away. */
  FAR_OBJECTS,
  /** Neighbourhoods of the proxy that were in the cache. */
  NEIGHBOURS,
  /** Searches for a step up that are known to fail. */
  CLIMBS,
  /** Frames in which the device and the proxy were at rest. */
  REST,
  /** Frames without a collision response, if the session asks for collision detection alone. */
  RESPONSE,
  /** Frames that needed no friction. */
  FRICTION;

  private final String key = name().toLowerCase(Locale.ROOT);

  /** {@return the name of this kind in reports} */
  public String key() {
    return key;
  }
}
