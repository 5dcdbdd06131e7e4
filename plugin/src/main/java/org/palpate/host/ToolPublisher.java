package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;
import org.palpate.scene.ToolMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.sync.NumberProperty;
import org.palpate.sync.PositionProperty;
import org.palpate.sync.TouchProperties;
import org.palpate.sync.TransformProperty;
import org.palpate.volume.VoxelGrid;

/**
 * Publishes the frames of a rigid tool. As for a point, a frame gives the device, the reference
 * point, the force and the contact. For a tool it also gives the poses of tool and bodies, the
 * torque and the points in contact.
 *
 * <p>Haptic thread; allocates nothing.
 */
final class ToolPublisher implements ToolFramePublisher {
  private final TouchProperties properties;
  private final VoxelGrid grid;
  private final TransformProperty toolToWorld;
  private final TransformProperty deviceToWorld;
  private final PositionProperty torqueNewtonMm;
  private final NumberProperty contactCount;
  private final PositionProperty[] contactMm = new PositionProperty[ToolContacts.MOST];
  private final Vec3 contactPoint = new Vec3();
  private final Vec3 deviceGrid = new Vec3();
  private final Vec3 pointGrid = new Vec3();
  private final Vec3 gridNewton = new Vec3();
  private final BodyScene bodies;

  /** The pose of each body that can move, from rest to present; null for the others. */
  private final TransformProperty[] bodyPoses;

  private final RigidTransform toWorld = RigidTransform.identity();

  /** Creates the properties of a tool beside those of a point, before the session starts. */
  ToolPublisher(TouchProperties properties, VoxelGrid grid, BodyScene bodies) {
    this.properties = properties;
    this.grid = grid;
    this.bodies = bodies;
    bodyPoses = new TransformProperty[bodies.count()];
    for (int n = 0; n < bodyPoses.length; n++) {
      if (bodies.body(n).mobility() == Mobility.MOVABLE) {
        bodyPoses[n] = properties.accumulator().transform("body " + n);
      }
    }
    toolToWorld = properties.accumulator().transform("tool");
    deviceToWorld = properties.accumulator().transform("device");
    torqueNewtonMm = properties.accumulator().position("torque");
    contactCount = properties.accumulator().number("contacts");
    for (int n = 0; n < contactMm.length; n++) {
      contactMm[n] = properties.accumulator().position("contact " + n);
    }
  }

  @Override
  public void publish(Pose device, ToolMotion motion, Vec3 forceNewton, Vec3 torque, long frame) {
    Pose pose = motion.pose();
    toolToWorld.set(pose.transform(toWorld));
    setContacts(motion);
    setBodyPoses();
    deviceToWorld.set(device.transform(toWorld));
    torqueNewtonMm.set(torque);
    grid.worldToGrid(device.translation, deviceGrid);
    grid.worldToGrid(pose.translation, pointGrid);
    grid.gridMmToWorld().inverseRotate(forceNewton, gridNewton);
    properties.publish(deviceGrid, pointGrid, gridNewton, motion.contact(), frame);
  }

  private void setContacts(ToolMotion motion) {
    int count = motion.contacts().count();
    contactCount.set(count);
    for (int n = 0; n < count; n++) {
      contactMm[n].set(motion.contactMm(n, contactPoint));
    }
  }

  private void setBodyPoses() {
    for (int n = 0; n < bodyPoses.length; n++) {
      if (bodyPoses[n] != null) {
        bodyPoses[n].set(bodies.body(n).pose().transform(toWorld));
      }
    }
  }

  /**
   * Returns the pose of a body from rest to present, world mm; empty for one that cannot move. It
   * is that of the publication that the reader took last.
   */
  Optional<RigidTransform> bodyPose(int body) {
    return Optional.ofNullable(bodyPoses[body]).map(TransformProperty::read);
  }

  /** Returns the present pose of each body that can move; a new list. See {@link #bodyPose}. */
  List<SessionReader.BodyPose> bodyPoses() {
    List<SessionReader.BodyPose> poses = new ArrayList<>();
    for (int n = 0; n < bodyPoses.length; n++) {
      String name = bodies.body(n).name();
      bodyPose(n).ifPresent(pose -> poses.add(new SessionReader.BodyPose(name, pose)));
    }
    return poses;
  }

  /** Returns the device pose, device frame to world mm. */
  TransformProperty deviceToWorld() {
    return deviceToWorld;
  }

  /** Returns the tool pose, tool frame to world mm. */
  TransformProperty toolToWorld() {
    return toolToWorld;
  }

  /**
   * Returns how the tool lay in the publication that was taken last.
   *
   * @param drawnPoints points of the tool's surface, tool frame
   * @param axes orientation of the world's axes
   */
  ToolMarks marks(List<Vec3> drawnPoints, WorldAxes axes) {
    Vec3 torque = torqueNewtonMm.read(new Vec3());
    return ToolMarks.at(drawnPoints, toolToWorld.read(), contactsMm(), torque, axes);
  }

  private List<Vec3> contactsMm() {
    List<Vec3> contacts = new ArrayList<>();
    for (int n = 0; n < (int) contactCount.read(); n++) {
      contacts.add(contactMm[n].read(new Vec3()));
    }
    return contacts;
  }

  /** Returns the torque on the hand about the reference point, world axes. */
  PositionProperty torqueNewtonMm() {
    return torqueNewtonMm;
  }
}
