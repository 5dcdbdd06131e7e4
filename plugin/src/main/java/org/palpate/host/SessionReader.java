package org.palpate.host;

import java.util.List;
import java.util.Optional;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.VoxelGrid;

/**
 * A second reader of the published frames of a session, for a program that shows the session
 * outside its view. Positions are in world mm, the force in N and the torque in N mm, along the
 * world's axes.
 *
 * <p>One thread calls {@link #take} and the other methods. The haptic thread never waits for it.
 */
public final class SessionReader {
  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final VoxelGrid grid;
  private final Optional<ToolPublisher> tool;
  private final Pose upright = new Pose();
  private final Vec3 scratch = new Vec3();

  /**
   * Creates a reader.
   *
   * @param bodies what a rigid tool touches; empty if the session holds none
   */
  SessionReader(VoxelGrid grid, Optional<BodyScene> bodies) {
    this.grid = grid;
    tool = bodies.map(touched -> new ToolPublisher(properties, grid, touched));
  }

  /**
   * The pose of a body.
   *
   * @param name the name of the body
   * @param restToPresent world mm
   */
  public record BodyPose(String name, RigidTransform restToPresent) {}

  /** Returns the properties into which the frames of a point publish. Haptic thread. */
  TouchProperties properties() {
    return properties;
  }

  /** Returns the publisher of the frames of a rigid tool. Haptic thread. */
  ToolPublisher toolPublisher() {
    return tool.orElseThrow();
  }

  /** Takes the newest frame, so that the other methods show it. */
  public void take() {
    properties.accumulator().take();
    properties.markApplied();
  }

  /**
   * Writes the pose of the device.
   *
   * @param dest its four vectors are overwritten
   */
  public void device(RigidTransform dest) {
    if (tool.isPresent()) {
      tool.get().deviceToWorld().read(dest);
    } else {
      properties.touch().device(scratch);
      setPosition(dest);
    }
  }

  /**
   * Writes the pose of the tool, or the position of the interaction point.
   *
   * @param dest its four vectors are overwritten
   */
  public void tool(RigidTransform dest) {
    if (tool.isPresent()) {
      tool.get().toolToWorld().read(dest);
    } else {
      properties.touch().interactionPoint(scratch);
      setPosition(dest);
    }
  }

  private void setPosition(RigidTransform dest) {
    upright.transform(dest);
    grid.gridToWorld(scratch, dest.origin());
  }

  /**
   * Writes the force on the hand.
   *
   * @param dest receives the force along the world's axes, N
   */
  public void force(Vec3 dest) {
    properties.touch().force(scratch);
    grid.gridMmToWorld().rotate(scratch, dest);
  }

  /**
   * Writes the torque on the hand about the tool's reference point; zero for a point.
   *
   * @param dest receives the torque along the world's axes, N mm
   */
  public void torque(Vec3 dest) {
    dest.set(0, 0, 0);
    tool.ifPresent(publisher -> publisher.torqueNewtonMm().read(dest));
  }

  /** {@return the poses of the bodies that can move; empty for a point} */
  public List<BodyPose> bodies() {
    return tool.map(ToolPublisher::bodyPoses).orElse(List.of());
  }

  /** {@return whether there is contact} */
  public boolean contact() {
    return properties.touch().contact();
  }
}
