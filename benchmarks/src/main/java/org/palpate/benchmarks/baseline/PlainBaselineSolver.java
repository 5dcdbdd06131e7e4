package org.palpate.benchmarks.baseline;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * Adapts the plain baseline to the interface of solvers. It has its own bits and records no legs.
 */
public final class PlainBaselineSolver implements ProxySolver {
  private final PlainBaseline baseline;
  private boolean placed;

  /** Creates a solver that starts at the point's position in the first frame after a reset. */
  public PlainBaselineSolver(PlainBaseline baseline) {
    this.baseline = baseline;
  }

  @Override
  public void reset() {
    placed = false;
  }

  @Override
  public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
    if (!placed) {
      baseline.place(point.position.x, point.position.y, point.position.z);
      placed = true;
    }
    baseline.frame(device.x, device.y, device.z);
    point.position.set(baseline.x(), baseline.y(), baseline.z());
    point.contact = baseline.contact();
    point.legs.clear();
  }
}
