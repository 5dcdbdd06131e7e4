package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;

/**
 * Decides which motions count, so that the point comes to rest, bit for bit, when the device does.
 *
 * <p>Rule. A frame in contact counts only if it leaves the {@link Potential} at or below a limit:
 * the potential before the frame, plus the distance that the device has moved since the last frame,
 * less {@link #LEAST_FALL_EDGES}. Otherwise the frame is taken back. A frame that reaches the
 * device counts too, unless the device lies in a solid cell of the field. Free-space motion towards
 * a device beyond w_max counts if the device has moved, or if the distance to it is smaller by
 * {@link #LEAST_FALL_EDGES} than at each such motion since.
 *
 * <p>Claim. While the device rests, only finitely many frames move the point.
 *
 * <p>Proof. A frame that ends at the device ends the sequence: the next leg has no length.
 * Free-space motions are finitely many, because the distance at which they start falls by a least
 * amount from each to the next and is not negative. After the last one each frame that moves the
 * point lowers the potential by at least {@link #LEAST_FALL_EDGES}. The potential is a fixed
 * function in doubles and bounded below, so there are finitely many such frames, and no cycle. A
 * frame that stops early because its work budget is spent falls under the same rule.
 *
 * <p>The rule is also the hysteresis between several closest points at about the same distance.
 */
final class RestRule {
  /** The least fall of the potential in a frame that counts while the device rests. */
  static final double LEAST_FALL_EDGES = 1e-6;

  private final Potential potential;
  private final EdgeUnits units;
  private final Vec3 lastDevice = new Vec3(Double.NaN, 0, 0);
  private double lastFreeDistanceEdges;
  private boolean deviceInSolid;

  RestRule(Potential potential, EdgeUnits units) {
    this.potential = potential;
    this.units = units;
  }

  /** Forgets where the device was; the next frame may do anything. */
  void reset() {
    lastDevice.x = Double.NaN;
  }

  /** Begins a frame; a device in a solid cell is not reached, even if its voxel is empty. */
  void beginFrame(boolean isDeviceInSolid) {
    deviceInSolid = isDeviceInSolid;
  }

  /** Ends a frame. */
  void endFrame(Vec3 device) {
    lastDevice.set(device);
  }

  /** Begins a frame with the device beyond w_max; if it has moved, any free motion may start. */
  void beginFarFrame(Vec3 device) {
    if (!device.sameBits(lastDevice)) {
      lastFreeDistanceEdges = Double.POSITIVE_INFINITY;
    }
  }

  /** Whether a free-space motion may start at this distance from the device. */
  boolean allowsFreeMotion(double distanceEdges) {
    return lastFreeDistanceEdges - distanceEdges >= LEAST_FALL_EDGES;
  }

  /** Notes a free-space motion that started at this distance from the device. */
  void noteFreeMotion(double distanceEdges) {
    lastFreeDistanceEdges = distanceEdges;
  }

  /** Returns the limit on the potential at the end of a frame that starts at this distance. */
  double potentialLimit(Vec3 point, Vec3 device, double distanceEdges) {
    return potential.at(point, distanceEdges) + allowedRise(device);
  }

  private double allowedRise(Vec3 device) {
    double movedEdges = units.distance(lastDevice, device);
    return Double.isNaN(movedEdges) ? Double.POSITIVE_INFINITY : movedEdges - LEAST_FALL_EDGES;
  }

  /** Whether a frame counts that leaves the point here. */
  boolean accepts(Vec3 point, Vec3 device, double limit) {
    boolean reached = !deviceInSolid && point.sameBits(device);
    return reached || potential.at(point, device) <= limit;
  }
}
