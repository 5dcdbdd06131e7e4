package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * What a haptic frame publishes, in an accumulator in which more properties may be made before the
 * session starts.
 *
 * <p>Positions are grid coordinates and the force is along the grid's axes, as the frame has them;
 * the reader (through {@code host}) takes them to the world.
 */
public final class TouchProperties {
  private final Accumulator accumulator;
  private final TouchProperty touch;

  /** Makes its property in {@code accumulator}. */
  public TouchProperties(Accumulator accumulator) {
    this.accumulator = accumulator;
    touch = accumulator.touch("touch");
  }

  /**
   * Sets all and publishes. Writer.
   *
   * @param frameNumber kept as it was where nothing else changed, so that a resting hand causes no
   *     redraw
   */
  public void publish(
      Vec3 deviceGrid, Vec3 pointGrid, Vec3 forceNewton, boolean touching, long frameNumber) {
    touch.set(deviceGrid, pointGrid, forceNewton, touching, frameNumber);
    accumulator.publish();
  }

  public Accumulator accumulator() {
    return accumulator;
  }

  /**
   * d and p in grid coordinates; what was written to the device in newtons along the grid's axes.
   */
  public TouchProperty touch() {
    return touch;
  }
}
