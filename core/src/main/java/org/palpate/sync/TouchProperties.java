package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * The properties that a haptic frame publishes, in one accumulator, so that they are always of the
 * same frame.
 *
 * <p>Positions are grid coordinates and the force is along the grid's axes, as the frame has them;
 * the reader (through {@code host}) takes them to the world. More properties may be made in the
 * same accumulator before the session starts.
 */
public final class TouchProperties {
  private final Accumulator accumulator;
  private final PositionProperty device;
  private final PositionProperty interactionPoint;
  private final PositionProperty force;
  private final VisibilityProperty contact;
  private final NumberProperty frame;

  /** Makes the properties in {@code accumulator}. */
  public TouchProperties(Accumulator accumulator) {
    this.accumulator = accumulator;
    device = accumulator.position("device");
    interactionPoint = accumulator.position("interaction point");
    force = accumulator.position("force");
    contact = accumulator.visibility("contact");
    frame = accumulator.number("frame");
  }

  /**
   * Sets all and publishes. Writer.
   *
   * @param frameNumber kept as it was where nothing else changed, so that a resting hand causes no
   *     redraw
   */
  public void publish(
      Vec3 deviceGrid, Vec3 pointGrid, Vec3 forceNewton, boolean touching, long frameNumber) {
    device.set(deviceGrid);
    interactionPoint.set(pointGrid);
    force.set(forceNewton);
    contact.set(touching);
    if (accumulator.isDirty()) {
      frame.set((double) frameNumber);
    }
    accumulator.publish();
  }

  public Accumulator accumulator() {
    return accumulator;
  }

  /** d, grid coordinates. */
  public PositionProperty device() {
    return device;
  }

  /** p, grid coordinates. */
  public PositionProperty interactionPoint() {
    return interactionPoint;
  }

  /** What was written to the device, newtons along the grid's axes. */
  public PositionProperty force() {
    return force;
  }

  /** True while there is contact. */
  public VisibilityProperty contact() {
    return contact;
  }

  /** The number of the last frame in which any of the others changed. */
  public NumberProperty frame() {
    return frame;
  }
}
