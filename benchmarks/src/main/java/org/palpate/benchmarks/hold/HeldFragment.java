package org.palpate.benchmarks.hold;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandStop;
import org.palpate.device.Tremor;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * A fragment of a bone that lies in its place, and the hand that takes hold of it there. From then
 * on the hand presses it against its neighbours, here and there, and trembles.
 *
 * @param points the number of its sample points
 * @param undersideMm a point on its underside, below which nothing lies, world mm
 */
record HeldFragment(int points, Vec3 undersideMm) {
  /** The distance from the fragment at which the hand begins. */
  private static final double BEGIN_MM = 20;

  /** The depth below the surface at which the hand takes hold. */
  private static final double PRESS_MM = 2;

  /** The farthest that the hand leads the fragment from its place, along each axis. */
  private static final double AWAY_MM = 3;

  /** The farthest that it turns the fragment, about each axis. */
  private static final double TURN_RAD = Math.toRadians(2);

  /** The time that the hand stays wherever it presses. */
  private static final double REST_SECONDS = 0.2;

  private static final double REACH_MM = 200;

  /**
   * Finds the movable fragment whose number of sample points is nearest to a given one.
   *
   * @param fragments cubes of 1 mm on one grid, whose grid coordinates are world mm
   * @param shapes their sample points
   * @throws IllegalArgumentException if a hand reaches none from below
   */
  static HeldFragment of(SegmentedVolume fragments, MovableShapes shapes, int points) {
    List<RigidTool> tools = shapes.shapes();
    List<BitCube> cubes = fragments.segments().stream().map(Segment::bits).toList();
    return IntStream.range(0, tools.size())
        .filter(n -> tools.get(n) != null)
        .boxed()
        .sorted(Comparator.comparing(n -> Math.abs(tools.get(n).count() - points)))
        .flatMap(
            n ->
                new Underside(cubes, n)
                        .flatPlace()
                        .map(place -> new HeldFragment(tools.get(n).count(), place))
                        .stream())
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no fragment can be taken from below"));
  }

  /**
   * Returns a hand that takes the fragment and presses it for some time at least.
   *
   * @param seed chooses where it presses, and the phases of its tremor
   * @param periodNanos time between two samples
   */
  GuidedHand hand(long seed, double seconds, long periodNanos) {
    List<HandStop> stops = new ArrayList<>();
    Pose touching = Pose.at(undersideMm.x, undersideMm.y, undersideMm.z + PRESS_MM);
    stops.add(
        new HandStop(Pose.at(undersideMm.x, undersideMm.y, undersideMm.z - BEGIN_MM), 0, 0, false));
    stops.add(new HandStop(touching, 0, REST_SECONDS, true));
    stops.add(new HandStop(touching, DeviceState.FIRST_BUTTON, REST_SECONDS, true));
    SplittableRandom random = new SplittableRandom(seed);
    for (double rested = 0; rested < seconds; rested += REST_SECONDS) {
      Pose pressing =
          touching.displace(
              inCube(random, AWAY_MM), inCube(random, TURN_RAD), 1, new Quaternion(), new Pose());
      stops.add(new HandStop(pressing, DeviceState.FIRST_BUTTON, REST_SECONDS, false));
    }
    return new GuidedHand(stops, Tremor.ofHand(seed), REACH_MM, periodNanos);
  }

  private static Vec3 inCube(SplittableRandom random, double half) {
    return new Vec3(
        random.nextDouble(-half, half),
        random.nextDouble(-half, half),
        random.nextDouble(-half, half));
  }
}
