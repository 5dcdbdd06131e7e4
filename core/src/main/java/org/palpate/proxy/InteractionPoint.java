package org.palpate.proxy;

import org.palpate.geometry.Vec3;

/**
 * The interaction point, p, and what the last frame did with it. Written by the solver, in the
 * haptic thread.
 */
public final class InteractionPoint {
  /** Value of {@link #touched} where no object is known to hold the point. */
  public static final int NOTHING = -1;

  /** Where it is, grid coordinates. */
  public final Vec3 position = new Vec3();

  /** The legs of the last frame. */
  public final LegPath legs = new LegPath();

  /**
   * Whether a solid stopped a leg, or the straight way from p to d is blocked at the frame's end.
   */
  public boolean contact;

  /**
   * How far outside the solids the surface runs on which the solver slides, mm: what is taken off
   * |p-d| before it is felt. 0 for solvers that slide on the voxels themselves.
   */
  public double surfaceHeightMm;

  /**
   * Whether the coupling force is to change no faster than the device moves, so that a jump of the
   * point is no knock. False for solvers whose force is their jump.
   */
  public boolean limitsForceRate;

  /**
   * The object that stops the point on its straight way to the device, by its place among the
   * obstacles, or {@link #NOTHING}; written by who wants to know, see {@link TouchedObjectFinder}.
   */
  public int touched = NOTHING;
}
