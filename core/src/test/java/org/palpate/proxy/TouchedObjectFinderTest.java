package org.palpate.proxy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class TouchedObjectFinderTest {
  private final BitCube first = new BitCube(8, 8, 8);
  private final BitCube second = new BitCube(8, 8, 8);
  private final InteractionPoint point = new InteractionPoint();

  private int find(Vec3 device, boolean contact) {
    point.position.set(1.5, 1.5, 1.5);
    point.contact = contact;
    point.touchedObject = 77;
    new TouchedObjectFinder().find(new CollisionScene(List.of(first, second)), device, point);
    return point.touchedObject;
  }

  @Test
  void theTouchedObjectIsTheFirstBetweenThePointAndTheDevice() {
    first.set(6, 1, 1);
    second.set(4, 1, 1);
    assertEquals(1, find(new Vec3(7.5, 1.5, 1.5), true));
    second.clear(4, 1, 1);
    assertEquals(0, find(new Vec3(7.5, 1.5, 1.5), true));
    second.set(6, 1, 1);
    assertEquals(0, find(new Vec3(7.5, 1.5, 1.5), true), "the first of those that share a voxel");
  }

  @Test
  void thereIsNoneWithoutContactOrSolidOrDevice() {
    first.set(6, 1, 1);
    assertEquals(InteractionPoint.NO_OBJECT, find(new Vec3(7.5, 1.5, 1.5), false));
    assertEquals(InteractionPoint.NO_OBJECT, find(new Vec3(5.5, 1.5, 1.5), true));
    assertEquals(InteractionPoint.NO_OBJECT, find(new Vec3(Double.NaN, 1.5, 1.5), true));
  }
}
