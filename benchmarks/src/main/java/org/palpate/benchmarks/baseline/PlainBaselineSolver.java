package org.palpate.benchmarks.baseline;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/** The plain twin behind the interface of the solvers; it has bits of its own and knows no legs. */
public final class PlainBaselineSolver implements ProxySolver {
  private final PlainBaseline twin;
  private boolean placed;

  /** A solver that starts where the point is in its first frame after {@link #reset}. */
  public PlainBaselineSolver(PlainBaseline twin) {
    this.twin = twin;
  }

  @Override
  public void reset() {
    placed = false;
  }

  @Override
  public void follow(CollisionScene obstacles, Vec3 device, InteractionPoint point) {
    if (!placed) {
      twin.place(point.position.x, point.position.y, point.position.z);
      placed = true;
    }
    twin.frame(device.x, device.y, device.z);
    point.position.set(twin.x(), twin.y(), twin.z());
    point.contact = twin.contact();
    point.legs.clear();
  }
}
