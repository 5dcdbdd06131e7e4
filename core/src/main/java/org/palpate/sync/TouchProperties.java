package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * The properties that a haptic frame publishes. More properties may be made in the same accumulator
 * before the session starts.
 *
 * <p>Positions are grid coordinates and the force is along the grid's axes, as in the frame. The
 * reader maps them to the world through {@code host}.
 */
public final class TouchProperties {
  private final Accumulator accumulator;
  private final TouchProperty touch;

  /**
   * Makes the properties.
   *
   * @param accumulator holds the properties
   */
  public TouchProperties(Accumulator accumulator) {
    this.accumulator = accumulator;
    touch = accumulator.touch("touch");
  }

  /**
   * Sets the result of a frame and publishes it. Writer.
   *
   * @param deviceGrid the device position, grid coordinates; copied
   * @param pointGrid the interaction point, grid coordinates; copied
   * @param forceNewton the written force along the grid's axes, N; copied
   * @param contact whether the frame ended in contact
   * @param frameNumber ignored if nothing else changed, so that a hand at rest causes no redraw
   */
  public void publish(
      Vec3 deviceGrid, Vec3 pointGrid, Vec3 forceNewton, boolean contact, long frameNumber) {
    touch.set(deviceGrid, pointGrid, forceNewton, contact, frameNumber);
    accumulator.publish();
  }

  /** Marks the values that were last taken as applied to the scene. Reader. */
  public void markApplied() {
    for (Property property : accumulator.properties()) {
      if (property.isDirty()) {
        property.markApplied();
      }
    }
  }

  /** {@return the accumulator that holds the properties} */
  public Accumulator accumulator() {
    return accumulator;
  }

  /**
   * {@return the result of a frame: d and p in grid coordinates, and the written force in newtons
   * along the grid's axes}
   */
  public TouchProperty touch() {
    return touch;
  }
}
