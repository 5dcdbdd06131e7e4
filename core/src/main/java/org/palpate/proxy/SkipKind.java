package org.palpate.proxy;

import java.util.Locale;

/** What a frame can leave out without a different answer. */
public enum SkipKind {
  /** Empty bricks, blocks of bricks and boxes inside a brick that a ray passed in one step. */
  EMPTY_BRICKS,
  /** Rays that lie wholly beside the box of all solids. */
  BESIDE_BOUNDS,
  /** Objects that were not looked at, since their bounds are far. */
  FAR_OBJECTS,
  /** Neighbourhoods of the point that were known from before. */
  NEIGHBOURS,
  /** Searches for a climb that were in vain before. */
  CLIMBS,
  /** Frames in which device and point rested. */
  REST,
  /** Frames without response, where collision alone was asked for. */
  RESPONSE,
  /** Frames that needed no friction. */
  FRICTION;

  private final String key = name().toLowerCase(Locale.ROOT);

  /** As reports name it. */
  public String key() {
    return key;
  }
}
