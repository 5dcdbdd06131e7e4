package org.palpate.force.needle;

import java.util.List;
import org.palpate.force.FramePart;
import org.palpate.force.ToolProposal;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.rigid.ToolMotion;
import org.palpate.volume.VoxelGrid;

/**
 * Moves a needle through layers of tissue. The solver does not see these layers; they only shape
 * where this class proposes that the needle goes.
 *
 * <p>Outside, the tip sticks where it meets a layer, until the coupling presses along the needle
 * with the puncture force of the layer. From then on the needle stays on its track: the straight
 * line of its axis at that moment. Along the track it moves with dry friction. The shaft rubs over
 * its length in each layer, and a tip that goes deeper than ever also cuts. A further layer is
 * punctured like the first one, by the force that the shaft leaves. In the hole that it has cut the
 * needle moves with the friction of the shaft alone. When the tip is out again, the track is
 * forgotten.
 *
 * <p>All forces resist motion, so the needle gives no energy to the hand. In a millisecond the tip
 * moves along the track by at most {@link #MOST_STEP_MM}, or by less against a solid, so that a
 * puncture makes no step.
 *
 * <p>World mm. Haptic thread; allocates nothing after it was made.
 */
public final class NeedleTrack implements ToolProposal {
  /** The most that the tip moves along its track in a millisecond, mm. */
  static final double MOST_STEP_MM = 0.25;

  /**
   * The same while a solid holds the needle, so that it does not leave its track along the solid.
   */
  static final double STEP_AT_SOLID_MM = 0.02;

  /** The distance from the surface at which the tip sticks, mm. */
  private static final double GAP_MM = 1e-6;

  private static final int NO_TISSUE = -1;

  private final NeedleTissue[] tissues;
  private final VoxelGrid grid;
  private final Vec3 tip;
  private final double lengthMm;
  private final double newtonPerMm;
  private final NeedleLayers layers = new NeedleLayers();
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();

  private final Pose proposed = new Pose();
  private final Vec3 entry = new Vec3();
  private final Vec3 along = new Vec3();
  private final Vec3 deviceTip = new Vec3();
  private final Vec3 toolTip = new Vec3();
  private final Vec3 axis = new Vec3();
  private final Vec3 from = new Vec3();
  private final Vec3 to = new Vec3();
  private final Vec3 scratch = new Vec3();
  private final Quaternion turn = new Quaternion();

  /** The tissue at the deepest place of the tip. */
  private int tissue = NO_TISSUE;

  private boolean isInside;
  private double depthMm;
  private double deepestMm;
  private int hitTissue;
  private double hitFraction;

  // Read after the last frame.
  private long punctures;
  private double everDeepestMm;

  /**
   * Creates a needle outside of all tissue.
   *
   * @param tissues the layers of tissue; the list is copied
   * @param grid the grid of the tissues, which rest
   * @param tip the tip in the frame of the tool, mm; the needle points along negative z
   * @param lengthMm the length of the shaft
   * @param newtonPerMm the stiffness of the coupling
   */
  public NeedleTrack(
      List<NeedleTissue> tissues, VoxelGrid grid, Vec3 tip, double lengthMm, double newtonPerMm) {
    this.tissues = tissues.toArray(new NeedleTissue[0]);
    this.grid = grid;
    this.tip = new Vec3().set(tip);
    this.lengthMm = lengthMm;
    this.newtonPerMm = newtonPerMm;
  }

  @Override
  public void reset(Pose tool) {
    isInside = false;
  }

  @Override
  public Pose propose(Pose device, ToolMotion motion, long elapsedNanos) {
    device.transform(tip, deviceTip);
    motion.pose().transform(tip, toolTip);
    device.rotation.rotate(axis.set(0, 0, -1), axis);
    proposed.set(device);
    if (!isInside) {
      approach(device);
    }
    if (isInside) {
      double mostMm = motion.contact() ? STEP_AT_SOLID_MM : MOST_STEP_MM;
      slide(device, mostMm * FramePart.ofNanos(elapsedNanos));
    }
    return proposed;
  }

  /** Lets the tip stick at the first layer on its way, or begins a track. */
  private void approach(Pose device) {
    if (!castAmongOthers(toolTip, deviceTip, NO_TISSUE)) {
      return;
    }
    deviceTip.sub(toolTip, scratch);
    double reachMm = scratch.length();
    double keptMm = Math.max(0, hitFraction * reachMm - GAP_MM);
    scratch.mul(reachMm > 0 ? keptMm / reachMm : 0, scratch).add(toolTip, entry);
    double pressing = newtonPerMm * deviceTip.sub(entry, scratch).dot(axis);
    if (pressing >= tissues[hitTissue].punctureNewton()) {
      beginTrack();
    } else {
      putTip(device.rotation, entry);
    }
  }

  private void beginTrack() {
    isInside = true;
    along.set(axis);
    depthMm = 0;
    deepestMm = 0;
    layers.clear();
    enter(hitTissue, 0);
  }

  private void enter(int next, double atMm) {
    layers.add(next, atMm);
    tissue = next;
    punctures += next >= 0 ? 1 : 0;
  }

  /** Moves the tip along the track, or leaves it. */
  private void slide(Pose device, double mostMm) {
    double wantedMm = deviceTip.sub(entry, scratch).dot(along);
    double reachedMm = toolTip.sub(entry, scratch).dot(along);
    depthMm = Math.min(depthMm, Math.max(0, reachedMm)); // A solid may hold the needle back.
    noteDeepest();
    double next = wantedMm < depthMm ? retracted(wantedMm) : advanced(wantedMm, depthMm + mostMm);
    depthMm = Math.max(depthMm - mostMm, Math.min(depthMm + mostMm, next));
    if (depthMm <= 0) {
      isInside = wantedMm > 0;
      depthMm = 0;
    }
    if (isInside) {
      putOnTrack(device);
    }
  }

  /** Notes how deep the tip has been, and whether it has left its layer there. */
  private void noteDeepest() {
    if (depthMm > deepestMm) {
      deepestMm = depthMm;
      everDeepestMm = Math.max(everDeepestMm, deepestMm);
      if (tissue >= 0 && !isIn(tissue, trackPosition(deepestMm, from))) {
        enter(NO_TISSUE, deepestMm);
      }
    }
  }

  private boolean isIn(int index, Vec3 position) {
    grid.worldToGrid(position, to);
    int i = (int) Math.floor(to.x);
    int j = (int) Math.floor(to.y);
    int k = (int) Math.floor(to.z);
    return grid.contains(i, j, k) && tissues[index].bits().get(i, j, k);
  }

  private double shaftNewton(double atMm) {
    return layers.frictionNewton(tissues, atMm - lengthMm, atMm);
  }

  private double retracted(double wantedMm) {
    double slackMm = shaftNewton(depthMm) / newtonPerMm;
    return Math.min(depthMm, wantedMm + slackMm);
  }

  private double advanced(double wantedMm, double reachMm) {
    double inHoleMm = balanced(wantedMm, depthMm, 0);
    if (inHoleMm < deepestMm) {
      return Math.max(depthMm, inHoleMm);
    }
    double cutting = tissue >= 0 ? tissues[tissue].cuttingNewton() : 0;
    double cutMm = balanced(wantedMm, deepestMm, cutting);
    if (cutMm <= deepestMm || reachMm <= deepestMm) {
      return deepestMm;
    }
    return throughLayers(wantedMm, Math.min(cutMm, reachMm));
  }

  /**
   * Returns the depth at which the coupling balances shaft and tip, if the tip goes on in the layer
   * in which it is; less than the depth if it does not.
   */
  private double balanced(double wantedMm, double fromMm, double tipNewton) {
    double surplus = newtonPerMm * (wantedMm - fromMm) - tipNewton - shaftNewton(fromMm);
    return fromMm + surplus / (newtonPerMm + layers.newtonPerMm(tissues, fromMm));
  }

  /**
   * Returns how deep the tip gets in fresh tissue; it stops at a layer that it does not puncture.
   */
  private double throughLayers(double wantedMm, double cutMm) {
    trackPosition(deepestMm, from);
    if (!castAmongOthers(from, trackPosition(cutMm, to), tissue)) {
      return cutMm;
    }
    double atMm = deepestMm + hitFraction * (cutMm - deepestMm);
    double pressing = newtonPerMm * (wantedMm - atMm) - shaftNewton(atMm);
    if (pressing >= tissues[hitTissue].punctureNewton()) {
      enter(hitTissue, atMm);
      return Math.max(atMm, balanced(wantedMm, atMm, tissues[hitTissue].cuttingNewton()));
    }
    return Math.max(deepestMm, atMm - GAP_MM);
  }

  private Vec3 trackPosition(double atMm, Vec3 dest) {
    return along.mul(atMm, dest).add(entry, dest);
  }

  /**
   * Finds the first layer on a straight way.
   *
   * @param except a layer that does not count; -1 for none
   */
  private boolean castAmongOthers(Vec3 start, Vec3 end, int except) {
    hitTissue = NO_TISSUE;
    hitFraction = Double.POSITIVE_INFINITY;
    grid.worldToGrid(start, scratch);
    ray.from(scratch.x, scratch.y, scratch.z);
    grid.worldToGrid(end, scratch);
    ray.to(scratch.x, scratch.y, scratch.z);
    for (int n = 0; n < tissues.length; n++) {
      if (n != except && caster.cast(tissues[n].bits(), ray, hit) && hit.t < hitFraction) {
        hitTissue = n;
        hitFraction = hit.t;
      }
    }
    return hitTissue != NO_TISSUE;
  }

  /** Proposes an orientation with the tip at a position. */
  private void putTip(Quaternion rotation, Vec3 position) {
    proposed.rotation.set(rotation);
    rotation.rotate(tip, scratch);
    position.sub(scratch, proposed.translation);
  }

  /** Proposes the present depth; the needle turns with the hand about the track alone. */
  private void putOnTrack(Pose device) {
    axis.cross(along, scratch);
    double sine = scratch.length();
    double angle = StrictMath.atan2(sine, axis.dot(along));
    turn.setRotationVector(scratch.mul(sine > 0 ? angle / sine : 0, scratch));
    turn.multiply(device.rotation, proposed.rotation);
    proposed.rotation.normalize();
    putTip(proposed.rotation, trackPosition(depthMm, from));
  }

  /** {@return whether the needle is in a track} */
  public boolean isInside() {
    return isInside;
  }

  /**
   * {@return how often a layer was punctured} Haptic thread, or any thread after the last frame.
   */
  public long punctures() {
    return punctures;
  }

  /** {@return the deepest place of the tip on any track, mm} Threads as {@link #punctures}. */
  public double deepestMm() {
    return everDeepestMm;
  }
}
