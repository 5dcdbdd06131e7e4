package org.palpate.testing;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Checks the guarantee frame by frame. Every leg must be disjoint from every closed solid voxel, in
 * exact arithmetic, and must start bit for bit where the last one ended.
 */
public final class LegJudge {
  private final BitCube bits;
  private final Ray ray = new Ray();
  private final Vec3 end = new Vec3();
  private long legCount;

  /** Makes a judge of a chain of legs that begins at {@code start}. */
  public LegJudge(BitCube bits, Vec3 start) {
    this.bits = bits;
    end.set(start);
  }

  /** Returns the number of legs so far. */
  public long legCount() {
    return legCount;
  }

  /** Returns the violation of the last frame, or null if there is none. */
  public String faultOf(InteractionPoint point) {
    LegPath legs = point.legs;
    for (int leg = 0; leg < legs.count(); leg++) {
      legCount++;
      ray.from(legs.start(leg, 0), legs.start(leg, 1), legs.start(leg, 2));
      ray.to(legs.end(leg, 0), legs.end(leg, 1), legs.end(leg, 2));
      if (!end.sameBits(new Vec3(ray.fromX, ray.fromY, ray.fromZ))) {
        return "leg " + leg + " starts at " + ray + " but the last one ended at " + end;
      }
      if (ExactOracle.touchesAny(bits, ray)) {
        return "leg " + leg + " touches a solid: " + ray;
      }
      end.set(ray.toX, ray.toY, ray.toZ);
    }
    return end.sameBits(point.position) ? null : "point " + point.position + " is not at " + end;
  }
}
