package org.palpate.benchmarks.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * A penalty method with a voxel map and a point shell, written plainly for a ball. The map holds
 * the layer of each solid voxel: 1 at the surface. A point in a solid voxel is pushed along its
 * inward normal, by its depth below the plane through the voxel's centre plus the layers above. The
 * sum is divided by a tenth of the number of contacts if there are more than 10. The tool is a mass
 * that a spring and a critical damper couple to the device, integrated once a millisecond.
 *
 * <p>Reference: McNeely, Puterbaugh and Troy, Six degree-of-freedom haptic rendering using voxel
 * sampling, 1999. The layers are those of their later work, so that deep points are pushed too.
 */
final class PenaltyPeer implements PeerTool {
  private static final double SECONDS = 1e-3;
  private static final double MASS_KG = 0.1;
  private static final double COUPLING_NEWTON_PER_M = 1_000;
  private static final double CONTACT_NEWTON_PER_M = 5_000;
  private static final double DAMPING = 2 * Math.sqrt(COUPLING_NEWTON_PER_M * MASS_KG);

  /** The number of contacts beyond which their sum is divided. */
  private static final double FULL_CONTACTS = 10;

  private static final double MM_PER_M = 1_000;

  /** Stands for a layer that is not known yet, and in the end for all below layer 126. */
  private static final byte UNKNOWN = Byte.MAX_VALUE;

  private final RigidTool tool;
  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final byte[] layers;
  private final double rmsRadiusMm;
  private final Pose pose = new Pose();
  private final Pose lastDevice = new Pose();
  private final Vec3 velocity = new Vec3();
  private final Vec3 spin = new Vec3();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();
  private final Vec3 arm = new Vec3();
  private final Vec3 push = new Vec3();
  private final Vec3 scratch = new Vec3();
  private final Quaternion quaternion = new Quaternion();

  PenaltyPeer(BitCube bits, RigidTool tool) {
    this.tool = tool;
    sizeX = bits.sizeX();
    sizeY = bits.sizeY();
    sizeZ = bits.sizeZ();
    rmsRadiusMm = tool.rmsRadiusMm();
    layers = layers(bits);
  }

  /** Returns the number of each voxel's layer: 0 in empty space, 1 at the surface. */
  private byte[] layers(BitCube bits) {
    byte[] map = new byte[sizeX * sizeY * sizeZ];
    for (int n = 0; n < map.length; n++) {
      map[n] = bits.get(n % sizeX, n / sizeX % sizeY, n / (sizeX * sizeY)) ? UNKNOWN : 0;
    }
    boolean found = true;
    for (byte layer = 1; found && layer < Byte.MAX_VALUE; layer++) {
      found = false;
      for (int n = 0; n < map.length; n++) {
        if (map[n] == UNKNOWN && isBelow(map, n, layer - 1)) {
          map[n] = layer;
          found = true;
        }
      }
    }
    return map;
  }

  /** Whether a voxel without a layer has a neighbour across a face in the layer above. */
  private boolean isBelow(byte[] map, int n, int above) {
    int i = n % sizeX;
    int j = n / sizeX % sizeY;
    int k = n / (sizeX * sizeY);
    return isInLayer(map, i - 1, j, k, above)
        || isInLayer(map, i + 1, j, k, above)
        || isInLayer(map, i, j - 1, k, above)
        || isInLayer(map, i, j + 1, k, above)
        || isInLayer(map, i, j, k - 1, above)
        || isInLayer(map, i, j, k + 1, above);
  }

  private boolean isInLayer(byte[] map, int i, int j, int k, int layer) {
    boolean inside = i >= 0 && j >= 0 && k >= 0 && i < sizeX && j < sizeY && k < sizeZ;
    return inside && map[(k * sizeY + j) * sizeX + i] == layer;
  }

  @Override
  public void place(Pose start) {
    pose.set(start);
    lastDevice.set(start);
    velocity.set(0, 0, 0);
    spin.set(0, 0, 0);
  }

  @Override
  public void follow(Pose device) {
    couple(device);
    addContacts();
    velocity.add(force.mul(SECONDS / MASS_KG, scratch), velocity); // m/s
    double inertia = MASS_KG * rmsRadiusMm * rmsRadiusMm / (MM_PER_M * MM_PER_M);
    spin.add(torque.mul(SECONDS / inertia, scratch), spin);
    velocity.mul(SECONDS * MM_PER_M, arm);
    spin.mul(SECONDS, push);
    pose.displace(arm, push, 1, quaternion, pose);
    lastDevice.set(device);
  }

  /** Sets force, N, and torque, N m, of spring and damper between tool and device. */
  private void couple(Pose device) {
    pose.differenceTo(device, force, torque, quaternion);
    lastDevice.differenceTo(device, arm, push, quaternion);
    arm.mul(1 / (SECONDS * MM_PER_M), arm).sub(velocity, arm);
    push.mul(1 / SECONDS, push).sub(spin, push);
    force.mul(COUPLING_NEWTON_PER_M / MM_PER_M, force);
    force.add(arm.mul(DAMPING, arm), force);
    double squaredRadius = rmsRadiusMm * rmsRadiusMm / (MM_PER_M * MM_PER_M);
    torque.mul(COUPLING_NEWTON_PER_M * squaredRadius, torque);
    torque.add(push.mul(DAMPING * squaredRadius, push), torque);
  }

  private void addContacts() {
    double contacts = 0;
    double forceX = 0;
    double forceY = 0;
    double forceZ = 0;
    double torqueX = 0;
    double torqueY = 0;
    double torqueZ = 0;
    for (int n = 0; n < tool.count(); n++) {
      pose.rotation.rotate(tool.point(n, arm), arm);
      if (pushOf(arm, push)) {
        contacts++;
        forceX += push.x;
        forceY += push.y;
        forceZ += push.z;
        arm.cross(push, push);
        torqueX += push.x;
        torqueY += push.y;
        torqueZ += push.z;
      }
    }
    double scale = 1 / Math.max(1, contacts / FULL_CONTACTS);
    force.add(scratch.set(scale * forceX, scale * forceY, scale * forceZ), force);
    double perM = scale / MM_PER_M;
    torque.add(scratch.set(perM * torqueX, perM * torqueY, perM * torqueZ), torque);
  }

  /**
   * Writes the force on a point, N.
   *
   * @param fromCentre from the ball's centre to the point, world mm
   * @return whether there is one
   */
  private boolean pushOf(Vec3 fromCentre, Vec3 dest) {
    double x = fromCentre.x + pose.translation.x;
    double y = fromCentre.y + pose.translation.y;
    double z = fromCentre.z + pose.translation.z;
    int i = (int) Math.floor(x);
    int j = (int) Math.floor(y);
    int k = (int) Math.floor(z);
    boolean inside = i >= 0 && j >= 0 && k >= 0 && i < sizeX && j < sizeY && k < sizeZ;
    int layer = inside ? layers[(k * sizeY + j) * sizeX + i] : 0;
    if (layer == 0) {
      return false;
    }
    fromCentre.mul(-1 / fromCentre.length(), dest); // the inward normal
    double below = (i + 0.5 - x) * dest.x + (j + 0.5 - y) * dest.y + (k + 0.5 - z) * dest.z;
    double depthMm = layer - 1 + Math.max(0, below);
    dest.mul(CONTACT_NEWTON_PER_M / MM_PER_M * depthMm, dest);
    return depthMm > 0;
  }

  @Override
  public Vec3 force(Pose device, Vec3 dest) {
    return pose.translation.sub(device.translation, dest);
  }

  @Override
  public int count() {
    return tool.count();
  }

  @Override
  public Vec3 point(int index, Vec3 dest) {
    return pose.transform(tool.point(index, dest), dest);
  }
}
