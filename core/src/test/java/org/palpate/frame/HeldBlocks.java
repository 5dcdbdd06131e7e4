package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A hand that touches blocks over a floor with a point, and takes the second body. */
abstract class HeldBlocks {
  static final long MS = 1_000_000;
  static final double STIFFNESS = 0.5;
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  final Vec3 hand = new Vec3(20, 20, 20);
  private long nowNanos = 1;

  abstract ToolFrame frame();

  /** Fills {@code state} with a fresh sample of the hand, for read number {@code read}. */
  ReadStatus sample(int read, DeviceState state) {
    return ScriptedDevice.fresh(state, read, hand.x, hand.y, hand.z);
  }

  /**
   * Makes a cuboid.
   *
   * @param layers the number of its solid layers along z
   * @param sizeZ the number of all layers
   */
  static Body body(String name, int x, int y, int layers, int sizeZ, Mobility mobility, Vec3 at) {
    BitCube bits = new BitCube(x, y, sizeZ);
    for (int n = 0; n < x * y * layers; n++) {
      bits.set(n % x, n / x % y, n / (x * y));
    }
    Body body = new Body(name, bits, VoxelGrid.ofUnitVoxels(x, y, sizeZ), mobility);
    Pose pose = new Pose();
    pose.translation.set(at);
    body.setPose(pose);
    return body;
  }

  static Body cube(String name, int edge, Vec3 at) {
    return body(name, edge, edge, edge, edge, Mobility.MOVABLE, at);
  }

  static ToolFrame newFrame(HapticDevice device, BodyScene bodies, EditQueue edits, int voxels) {
    RigidTool point = ToolSampler.point();
    MovableShapes shapes = MovableShapes.ofWholeBodies(bodies, 0);
    RigidSettings settings = RigidSettings.of(4, Clearance.POINTS);
    return new ToolFrame(
        device,
        bodies,
        new RigidSolver(new RigidScene(bodies, point, shapes, settings)),
        RigidCoupling.of(point, STIFFNESS),
        new FrameSettings(
            ForceSettings.of(STIFFNESS, 0),
            INFINITE,
            INFINITE,
            0,
            20 * MS,
            voxels,
            INFINITE,
            INFINITE),
        edits,
        ToolFramePublisher.NONE);
  }

  final void run(int frames) {
    for (int n = 0; n < frames; n++) {
      frame().run(nowNanos);
      nowNanos += MS;
    }
  }

  /** Moves the hand in steps of a tenth of a millimetre. */
  final void moveTo(double x, double y, double z) {
    Vec3 way = new Vec3(x, y, z).sub(hand, new Vec3());
    int steps = (int) Math.ceil(way.length() * 10);
    way.mul(1.0 / steps, way);
    for (int n = 0; n < steps; n++) {
      hand.add(way, hand);
      run(1);
    }
    run(50);
  }

  final void takeBlock() {
    moveTo(20, 20, 15); // a millimetre below its upper face
    assertTrue(frame().motion().contact());
    frame().requestTake();
    run(1);
    assertEquals(1, frame().heldBody());
  }

  /** Takes the block, lets it go when the hand is at a height, and raises the hand farther. */
  final void placeBlockAbove(double z) {
    takeBlock();
    moveTo(20, 20, z);
    frame().requestLetGo();
    run(1);
    moveTo(20, 20, z + 15);
  }
}
