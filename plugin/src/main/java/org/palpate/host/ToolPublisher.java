package org.palpate.host;

import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.sync.PositionProperty;
import org.palpate.sync.TouchProperties;
import org.palpate.sync.TransformProperty;
import org.palpate.volume.VoxelGrid;

/**
 * Publishes the frames of a rigid tool. One publication holds device, reference point, force and
 * contact, as for a point, and the poses and the torque.
 *
 * <p>Haptic thread; allocates nothing.
 */
final class ToolPublisher implements ToolFramePublisher {
  private final TouchProperties properties;
  private final VoxelGrid grid;
  private final TransformProperty toolToWorld;
  private final TransformProperty deviceToWorld;
  private final PositionProperty torqueNewtonMm;
  private final Vec3 deviceGrid = new Vec3();
  private final Vec3 pointGrid = new Vec3();
  private final Vec3 gridNewton = new Vec3();
  private final RigidTransform toWorld = RigidTransform.identity();

  /** Creates the properties of a tool beside those of a point, before the session starts. */
  ToolPublisher(TouchProperties properties, VoxelGrid grid) {
    this.properties = properties;
    this.grid = grid;
    toolToWorld = properties.accumulator().transform("tool");
    deviceToWorld = properties.accumulator().transform("device");
    torqueNewtonMm = properties.accumulator().position("torque");
  }

  @Override
  public void publish(
      Pose device, Pose tool, Vec3 forceNewton, Vec3 torque, boolean contact, long frame) {
    toolToWorld.set(tool.transform(toWorld));
    deviceToWorld.set(device.transform(toWorld));
    torqueNewtonMm.set(torque);
    grid.worldToGrid(device.translation, deviceGrid);
    grid.worldToGrid(tool.translation, pointGrid);
    grid.gridMmToWorld().inverseRotate(forceNewton, gridNewton);
    properties.publish(deviceGrid, pointGrid, gridNewton, contact, frame);
  }

  /** Returns the device pose, device frame to world mm. */
  TransformProperty deviceToWorld() {
    return deviceToWorld;
  }

  /** Returns the tool pose, tool frame to world mm. */
  TransformProperty toolToWorld() {
    return toolToWorld;
  }

  /** Returns the torque on the hand about the reference point, world axes. */
  PositionProperty torqueNewtonMm() {
    return torqueNewtonMm;
  }
}
