package org.palpate.body;

/** Whether and how a body can move. */
public enum Mobility {
  /** Stands still. */
  FIXED,

  /** Moves as a whole. */
  MOVABLE,

  /** Deforms; its voxels stand still in material coordinates. */
  ELASTIC
}
