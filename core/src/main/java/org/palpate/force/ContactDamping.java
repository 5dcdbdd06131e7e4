package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Damping in contact: a force against the speed of the hand along the coupling force.
 *
 * <p>Damping is never longer than the coupling force. It therefore begins and ends without a jump
 * where contact does, and never holds the hand back in the solid.
 *
 * <p>The speed is that of the device between two frames. It is smoothed over {@link #SMOOTHING_MS},
 * because encoders have steps. Haptic thread; allocates nothing.
 */
final class ContactDamping {
  static final double SMOOTHING_MS = 4;

  private static final double NANOS_PER_MS = 1e6;
  private static final double MS_PER_S = 1e3;

  private final GridMetric metric;
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 step = new Vec3();
  private final Vec3 velocityMmPerMs = new Vec3();
  private boolean begun;

  ContactDamping(GridMetric metric) {
    this.metric = metric;
  }

  /** Forgets the speed of the hand. */
  void reset() {
    begun = false;
  }

  /**
   * Updates the speed of the hand.
   *
   * @param device d, grid coordinates
   * @param elapsedNanos time since the last update; 0 or less leaves the speed as it was
   */
  void update(Vec3 device, long elapsedNanos) {
    if (!begun) {
      velocityMmPerMs.set(0, 0, 0);
    } else if (elapsedNanos > 0) {
      smooth(device, elapsedNanos / NANOS_PER_MS);
    }
    begun = true;
    lastDevice.set(device);
  }

  private void smooth(Vec3 device, double ms) {
    step.set(
        (device.x - lastDevice.x) * metric.spacingX(),
        (device.y - lastDevice.y) * metric.spacingY(),
        (device.z - lastDevice.z) * metric.spacingZ());
    smooth(step, ms, SMOOTHING_MS, velocityMmPerMs);
  }

  /**
   * Moves a speed by t / (T + t) towards that of the last step.
   *
   * @param step what was covered in the time t
   * @param time t, in the unit of time of the speed
   * @param smoothing T, in the same unit
   * @param speed changed
   */
  static void smooth(Vec3 step, double time, double smoothing, Vec3 speed) {
    double weight = 1 / (smoothing + time);
    speed.x += weight * (step.x - time * speed.x);
    speed.y += weight * (step.y - time * speed.y);
    speed.z += weight * (step.z - time * speed.z);
  }

  /** Writes the damping force, which acts along the coupling force, N. */
  void compute(Vec3 coupling, double newtonSecondPerMm, Vec3 dest) {
    double length = coupling.length();
    coupling.mul(length > 0 ? 1 / length : 0, dest);
    dest.mul(newton(coupling, newtonSecondPerMm), dest);
  }

  /** Returns the damping force along the coupling force, N; negative if the hand moves out. */
  double newton(Vec3 coupling, double newtonSecondPerMm) {
    double length = coupling.length();
    if (!(length > 0)) {
      return 0;
    }
    double inwardMmPerS = -MS_PER_S * velocityMmPerMs.dot(coupling) / length;
    return Math.max(-length, Math.min(length, newtonSecondPerMm * inwardMmPerS));
  }
}
