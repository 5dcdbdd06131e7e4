package org.palpate.proxy;

import org.palpate.geometry.Vec3;

/**
 * The interaction point, p, and its motion and contact in the last frame: the output of a {@link
 * ProxySolver} and the input of the force.
 *
 * <p>Frame: grid coordinates. Thread: the haptic thread alone. Writer: the solver, in {@link
 * ProxySolver#follow}, except for {@link #touchedObject}, which {@link TouchedObjectFinder} writes.
 * Before its first frame, set {@link #position} to a point that touches no solid.
 */
public final class InteractionPoint {
  /** The value of {@link #touchedObject} if no object is known to stop the point. */
  public static final int NO_OBJECT = -1;

  /** The position of the point at the end of the last frame, grid coordinates. */
  public final Vec3 position = new Vec3();

  /** The legs of the last frame, from the position before it to {@link #position}. */
  public final LegPath legs = new LegPath();

  /**
   * Whether a solid stopped a leg of the last frame, or blocks the straight segment from p to the
   * device at its end.
   */
  public boolean contact;

  /**
   * The height above the solids of the surface that the solver slides on, mm. The force subtracts
   * it from the distance |p-d|. It is 0 for solvers that slide on the voxels themselves.
   */
  public double surfaceHeightMm;

  /**
   * Whether the coupling force may change no faster than the device moves, so that a jump of the
   * point is not felt as a knock. False for solvers whose force is meant to jump.
   */
  public boolean limitsForceRate;

  /**
   * The index in the collision scene of the object that stops the point on its straight segment to
   * the device, or {@link #NO_OBJECT}. Known only if {@link TouchedObjectFinder} was asked.
   */
  public int touchedObject = NO_OBJECT;
}
