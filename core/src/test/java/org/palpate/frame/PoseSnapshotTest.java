package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class PoseSnapshotTest {
  private final BodyScene bodies =
      new BodyScene(List.of(body("a", Mobility.FIXED), body("b", Mobility.MOVABLE)));

  private static Body body(String name, Mobility mobility) {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 1, 1);
    return new Body(name, bits, VoxelGrid.ofUnitVoxels(4, 4, 4), mobility);
  }

  private Pose move(double xMm) {
    Pose pose = Pose.at(xMm, 1 / 3.0, -7);
    pose.rotation.setRotationVector(new Vec3(0.1, -0.2, 0.3));
    bodies.body(1).setPose(pose);
    return pose;
  }

  private static void assertHolds(Pose expected, PoseSnapshot snapshot) {
    assertTrue(snapshot.isReady());
    assertTrue(snapshot.poses().get(0).sameBits(new Pose()));
    assertTrue(snapshot.poses().get(1).sameBits(expected));
  }

  @Test
  void aFrameCopiesPosesToTheBitOnceTheyAreRequested() {
    Pose first = move(1);
    PoseSnapshot snapshot = new PoseSnapshot(bodies);
    Pose second = move(2);
    snapshot.copyIfRequested();
    assertHolds(first, snapshot);
    snapshot.request();
    assertFalse(snapshot.isReady());
    snapshot.copyIfRequested();
    assertHolds(second, snapshot);
    move(3);
    snapshot.copyIfRequested();
    assertHolds(second, snapshot);
  }

  @Test
  void whoReadsPosesMayChangeThem() {
    PoseSnapshot snapshot = new PoseSnapshot(bodies);
    snapshot.poses().get(1).translation.x = 5;
    assertHolds(new Pose(), snapshot);
  }
}
