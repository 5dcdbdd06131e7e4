package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Damping in contact: a force against the speed at which the hand goes in or out along the coupling
 * force, never longer than that force. So it begins and ends with contact without a jump and never
 * holds the hand back in the solid.
 *
 * <p>Speed is that of the device between two frames, smoothed over {@link #SMOOTHING_MS}, for
 * encoders have steps. Haptic thread; allocates nothing.
 */
final class ContactDamping {
  static final double SMOOTHING_MS = 4;

  private static final double NANOS_PER_MS = 1e6;
  private static final double MS_PER_S = 1e3;

  private final GridMetric metric;
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 mmPerMs = new Vec3();
  private boolean begun;

  ContactDamping(GridMetric metric) {
    this.metric = metric;
  }

  /** Forgets how fast the hand was. */
  void forget() {
    begun = false;
  }

  /** Sees where the hand is; {@code elapsedNanos} of 0 or less tell nothing of its speed. */
  void observe(Vec3 device, long elapsedNanos) {
    if (!begun) {
      mmPerMs.set(0, 0, 0);
    } else if (elapsedNanos > 0) {
      double ms = elapsedNanos / NANOS_PER_MS;
      double share = 1 / (SMOOTHING_MS + ms);
      // share * ms of the new speed, which is the way over ms
      mmPerMs.x += share * ((device.x - lastDevice.x) * metric.spacingX() - ms * mmPerMs.x);
      mmPerMs.y += share * ((device.y - lastDevice.y) * metric.spacingY() - ms * mmPerMs.y);
      mmPerMs.z += share * ((device.z - lastDevice.z) * metric.spacingZ() - ms * mmPerMs.z);
    }
    begun = true;
    lastDevice.set(device);
  }

  /** The damping force along the coupling force, N; negative where the hand comes out. */
  double newton(Vec3 coupling, double newtonSecondPerMm) {
    double length = coupling.length();
    if (!(length > 0)) {
      return 0;
    }
    double inwardMmPerS = -MS_PER_S * mmPerMs.dot(coupling) / length;
    return Math.max(-length, Math.min(length, newtonSecondPerMm * inwardMmPerS));
  }
}
