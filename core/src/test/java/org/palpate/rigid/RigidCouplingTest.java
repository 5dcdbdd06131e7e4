package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;

class RigidCouplingTest {
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();

  @Test
  void pullsTheHandTowardsTheToolAndTurnsItTheShortWay() {
    Pose tool = new Pose();
    tool.translation.set(1, 2, 3);
    tool.rotation.setRotationVector(new Vec3(0, 0, 0.4));
    Pose device = new Pose();
    device.translation.set(1, 2, 1);
    device.rotation.setRotationVector(new Vec3(0, 0, 0.1));
    RigidCoupling coupling = new RigidCoupling(0.5, 20);
    coupling.compute(tool, device, force, torque);
    assertEquals(1, force.z, 1e-12);
    assertEquals(6, torque.z, 1e-12);
    device.rotation.negate(device.rotation);
    coupling.compute(tool, device, force, torque);
    assertEquals(6, torque.z, 1e-12);
  }

  @Test
  void theDefaultRotationalStiffnessIsThatOfTheMatter() {
    RigidTool sphere = ToolSampler.ofShape(RodShape.sphere(5), 1);
    assertEquals(2 * 15, RigidCoupling.of(sphere, 2).rotationalStiffness(), 0.2);
    assertEquals(0, RigidCoupling.of(ToolSampler.point(), 2).rotationalStiffness());
    assertThrows(IllegalArgumentException.class, () -> new RigidCoupling(-1, 0));
    assertThrows(IllegalArgumentException.class, () -> new RigidCoupling(1, Double.NaN));
  }

  @Test
  void theSamePoseGivesNoForceAtAll() {
    Pose pose = new Pose();
    pose.translation.set(1, 2, 3);
    pose.rotation.setRotationVector(new Vec3(0.1, 1, 0.4));
    new RigidCoupling(3, 70).compute(pose, pose, force, torque);
    assertEquals(0, force.length());
    assertEquals(0, torque.length(), 1e-12);
  }

  @Test
  void aJumpOfTheToolReachesTheHandNoFasterThanTheDeviceMoves() {
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(5), 1);
    CouplingRateLimit limit = new CouplingRateLimit(tool, 0.02);
    Pose device = new Pose();
    Pose pose = new Pose();
    pose.translation.set(0, 0, 1);
    assertEquals(0, limit.limit(pose, device, 1, force, torque));
    pose.translation.z = 3;
    assertEquals(1.98, limit.limit(pose, device, 1, force, torque), 1e-12);
    assertEquals(1.02, force.z, 1e-12);
    device.translation.x = 0.5;
    limit.limit(pose, device, 1, force, torque);
    assertEquals(0.5, force.sub(new Vec3(0, 0, 1.02), new Vec3()).length(), 1e-12);
    for (int frame = 0; frame < 200; frame++) {
      limit.limit(pose, device, 1, force, torque);
    }
    assertEquals(3, force.z, 1e-12);
    assertEquals(-0.5, force.x, 1e-12);
  }
}
