package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.device.DeviceState;
import org.palpate.device.HandStop;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * The stops of a hand that leads a fragment home on a way.
 *
 * @param poses from its place to where it is out, rest to present
 * @param back the number of stops before home at which the hand begins anew after its last try
 */
record WayHome(List<Pose> poses, int back) {
  private static final double SETTLE_SECONDS = 0.8;

  /**
   * The distances to which a fragment goes back for another try, shortest voxel edges. Faces that
   * have met a voxel beside their place come free by a little; others need more room.
   */
  private static final double[] BACK_EDGES = {1, 1.5, 2, 3, 8};

  /** The part of a distance that counts as all of it, because distances of poses are rounded. */
  private static final double WHOLE = 1 - 1e-9;

  /** Copies the poses. */
  WayHome {
    poses = List.copyOf(poses);
  }

  /**
   * Returns a way with the poses at which the hand stops.
   *
   * @param found from the place of a fragment to where it is out
   * @param edgeMm the shortest voxel edge
   */
  static WayHome of(List<Pose> found, double edgeMm, RigidTool shape) {
    return back(Ways.simplified(found, backMm(edgeMm), shape), edgeMm, shape);
  }

  /** Returns a straight way. */
  static WayHome straight(
      Pose place, Vec3 direction, double lengthMm, double edgeMm, RigidTool shape) {
    List<Pose> way = new ArrayList<>(List.of(place));
    Arrays.stream(backMm(edgeMm)).forEach(mm -> way.add(shifted(place, direction, mm)));
    way.add(shifted(place, direction, lengthMm));
    return back(way, edgeMm, shape);
  }

  private static WayHome back(List<Pose> way, double edgeMm, RigidTool shape) {
    double farMm = BACK_EDGES[BACK_EDGES.length - 1] * edgeMm * WHOLE;
    return new WayHome(way, Ways.stopsTo(farMm, way, shape));
  }

  private static double[] backMm(double edgeMm) {
    return Arrays.stream(BACK_EDGES).map(n -> n * edgeMm).toArray();
  }

  /** Returns a pose that is moved along a direction, a unit vector. */
  static Pose shifted(Pose pose, Vec3 direction, double mm) {
    Pose shifted = new Pose().set(pose);
    shifted.translation.add(direction.mul(mm, new Vec3()), shifted.translation);
    return shifted;
  }

  /** Returns the pose of the fragment in its place. */
  Pose place() {
    return poses.get(0);
  }

  /** Returns the pose of the fragment where it is out. */
  Pose out() {
    return poses.get(poses.size() - 1);
  }

  /** Returns the part of the way that a hand repeats. */
  WayHome near() {
    return new WayHome(poses.subList(0, back + 1), back);
  }

  /** Returns the number of stops that {@link #addTo} adds. */
  int stops() {
    return poses.size() - 1;
  }

  /**
   * Adds the stops after the first pose, where the fragment is out.
   *
   * @param toHand the pose of the hand in the frame of the fragment
   * @param seen returns the present pose of the fragment
   * @param tries the most times that the hand comes home
   * @param next the number of stops from home to the next
   * @param otherwise the same if no try succeeds
   */
  void addTo(
      List<HandStop> dest, Pose toHand, Supplier<Pose> seen, int tries, int next, int otherwise) {
    for (int n = poses.size() - 2; n > 0; n--) {
      Pose hand = poses.get(n).multiply(toHand, new Pose());
      dest.add(new HandStop(hand, DeviceState.FIRST_BUTTON, 0, false));
    }
    dest.add(
        new HandStop(
            place().multiply(toHand, new Pose()),
            DeviceState.FIRST_BUTTON,
            SETTLE_SECONDS,
            true,
            Optional.of(new HandStop.Aim(seen, place(), tries, back, otherwise)),
            next));
  }
}
