package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/**
 * Lets the coupling force change no faster than the hand moves, so that a point that jumps, from a
 * surface to the voxels in a slit or over a rim, is felt as a push that builds up and not as a
 * knock: in one frame by at most {@link #MOST_SHARE} k times the device's motion, and by that of
 * {@link #LEAST_MOTION_EDGES} where the device moves less, so that the force always arrives. Haptic
 * thread.
 */
final class ForceRateLimit {
  static final double MOST_SHARE = 1.5;

  /** In shortest voxel edges. */
  static final double LEAST_MOTION_EDGES = 0.05;

  private final GridMetric metric;
  private final double leastMotionMm;
  private final Vec3 lastForceNewton = new Vec3();
  private final Vec3 lastDevice = new Vec3();
  private boolean begun;
  private boolean behind;
  private long events;

  ForceRateLimit(GridMetric metric) {
    this.metric = metric;
    leastMotionMm = LEAST_MOTION_EDGES * metric.shortestEdgeMm();
  }

  /** How often the force began to lag behind a jump. */
  long events() {
    return events;
  }

  /** Takes the next force as it is. */
  void forget() {
    begun = false;
    behind = false;
  }

  /** Limits the change of {@code forceNewton} in place. */
  void limit(Vec3 forceNewton, Vec3 device, double stiffnessNewtonPerMm) {
    if (begun) {
      approach(forceNewton, mostChange(device, stiffnessNewtonPerMm));
    }
    begun = true;
    lastForceNewton.set(forceNewton);
    lastDevice.set(device);
  }

  private double mostChange(Vec3 device, double stiffness) {
    double motionMm =
        metric.distance(lastDevice.x, lastDevice.y, lastDevice.z, device.x, device.y, device.z);
    return MOST_SHARE * stiffness * Math.max(motionMm, leastMotionMm);
  }

  private void approach(Vec3 force, double most) {
    double x = force.x - lastForceNewton.x;
    double y = force.y - lastForceNewton.y;
    double z = force.z - lastForceNewton.z;
    double change = Math.sqrt(x * x + y * y + z * z);
    boolean jumps = change > most;
    if (jumps) {
      double share = most / change;
      force.set(
          lastForceNewton.x + share * x,
          lastForceNewton.y + share * y,
          lastForceNewton.z + share * z);
      events += behind ? 0 : 1;
    }
    behind = jumps;
  }
}
