package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandStop;
import org.palpate.device.Tremor;
import org.palpate.geometry.Pose;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/**
 * Leads a fragment home on a way in a copy of the scene, with a hand that trembles, to find out
 * whether it arrives. The hand holds the fragment at its middle, and its tremor has other phases
 * than that of the hand that carries the plan out.
 *
 * <p>World mm; poses are rest to present. One thread.
 */
final class Rehearsal {
  /** A fragment has arrived within this distance from its place, in the kinetic metric, edges. */
  private static final double ARRIVED_EDGES = 0.3;

  /** The number of times that a way is rehearsed on which a fragment arrives. */
  private static final int TIMES = 4;

  /** The most times that the hand comes home in one of them. */
  private static final int TRIES = 2;

  private static final long FRAME_NANOS = 1_000_000;
  private static final double REACH_MM = 100;

  private final BodyScene bodies;
  private final RigidSolver point;
  private final RigidSolver[] hands;
  private final ToolMotion motion;
  private final DeviceState state = new DeviceState();
  private final Pose device = new Pose();
  private long framesLeft;

  /**
   * Creates a rehearsal.
   *
   * @param bodies the bodies in their places; the rehearsal moves them, and puts them back
   * @param shapes their sample points, and the clearance that they keep
   * @param mostFrames the most frames of all rehearsals
   * @throws RigidScene.BodiesOverlapException if two bodies overlap in their places
   */
  Rehearsal(BodyScene bodies, MovableShapes shapes, long mostFrames) {
    this.bodies = bodies;
    framesLeft = mostFrames;
    point = PullSearch.solver(bodies, shapes);
    motion = point.newMotion();
    hands = new RigidSolver[bodies.count()];
  }

  /**
   * Rehearses a way until the fragment does not arrive, {@value #TIMES} times at most. Once the
   * frames of all rehearsals are spent, it rehearses nothing, and the fragment counts as arrived.
   *
   * @param found from the place of the fragment to where it is out
   * @return the number of times that the fragment arrived, over {@value #TIMES}
   */
  double arrivals(int fragment, List<Pose> found) {
    if (hands[fragment] == null) {
      hands[fragment] = point.ofBody(fragment);
    }
    RigidTool shape = hands[fragment].shape();
    WayHome way = WayHome.of(found, bodies.shortestEdgeMm(), shape).near();
    int count = 0;
    while (count < TIMES && (framesLeft <= 0 || arrives(fragment, way, count))) {
      count++;
    }
    bodies.body(fragment).setPose(way.place());
    return (double) count / TIMES;
  }

  private boolean arrives(int fragment, WayHome way, long seed) {
    PullSearch.requireWanted();
    RigidSolver solver = hands[fragment];
    Body body = bodies.body(fragment);
    Pose toHand = new Pose();
    solver.shape().referenceMm(toHand.translation);
    List<HandStop> stops = new ArrayList<>();
    stops.add(
        new HandStop(way.out().multiply(toHand, new Pose()), DeviceState.FIRST_BUTTON, 0, false));
    way.addTo(stops, toHand, body::pose, TRIES, 1, 1);
    GuidedHand hand = new GuidedHand(stops, Tremor.ofHand(seed), REACH_MM, FRAME_NANOS);
    body.setPose(way.out());
    point.place(PullSearch.NOWHERE, motion);
    solver.takeOver(motion);
    Pose home = way.place().multiply(toHand, new Pose());
    double arrivedMm = ARRIVED_EDGES * bodies.shortestEdgeMm();
    while (!hand.hasArrived()) {
      hand.read(state);
      solver.follow(device.set(state.positionMm, state.orientation), motion);
      framesLeft--;
      if (solver.shape().metric().distance(motion.pose(), home) < arrivedMm) {
        return true;
      }
    }
    return false;
  }
}
