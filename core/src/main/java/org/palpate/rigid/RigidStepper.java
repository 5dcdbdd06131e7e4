package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SampleNeighbours;

/**
 * Moves a tool towards a target by verified steps. A step is proposed such that the known contacts
 * allow it, and the legs of all points are verified. If legs touch a solid, contacts are added for
 * them and the step is proposed again. Only a free step is committed. The next step begins with the
 * contacts of the last one.
 *
 * <p>Contacts are generated lazily: only points whose legs have touched a solid, or that were
 * contacts before, are held to the isosurface. Haptic thread only; allocates nothing.
 */
final class RigidStepper {
  /** The most proposals of a step. */
  private static final int MOST_PROPOSALS = 14;

  /** The most contacts that are added after a proposal whose legs touch a solid. */
  private static final int MOST_NEW_CONTACTS = 10;

  /** The smallest fraction of a blocked proposal that is tried. */
  private static final double SMALLEST_FRACTION = 0.05;

  /** The least difference of height at which a point counts as lower, edges. */
  private static final double LOWER_EDGES = 0.1;

  /** Contacts of a curved surface that are nearer to each other count as one, edges. */
  private static final double SAME_PLACE_EDGES = 0.25;

  /** The shortest path of a lift that is proposed, edges. */
  private static final double SHORTEST_LIFT_EDGES = 1e-3;

  final MoverVerifier verifier;
  final ContactConstraints contacts;

  private final RigidTool tool;
  private final WorkBudget budget;
  private final double edgeMm;
  private final LegHits hits = new LegHits();
  private final Pose candidate = new Pose();
  private final Quaternion scratch = new Quaternion();
  private final Vec3 displacement = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 position = new Vec3();
  private final Vec3 push = new Vec3();
  private final Vec3 own = new Vec3();
  private final double[] metric = new double[6];
  private final KeptContacts kept = new KeptContacts();
  private double depthMm;
  private ToolMotion motion;
  private Pose target;
  private double pathLeftMm;
  private double shortestPathMm;

  /** Whether the faces of voxels hold the step, and the smooth surface does not. */
  private boolean onFaces;

  /**
   * Creates a stepper.
   *
   * @param edgeMm the shortest voxel edge of the scene
   */
  RigidStepper(MoverVerifier verifier, WorkBudget budget, double edgeMm) {
    this.verifier = verifier;
    this.budget = budget;
    this.edgeMm = edgeMm;
    tool = verifier.mover.shape;
    contacts = new ContactConstraints(tool.metric(), edgeMm);
  }

  /** Removes all contacts, after the tool was placed anew. */
  void reset() {
    kept.clear();
    depthMm = 0;
  }

  /** Returns the depth below the isosurface at which contacts may slide, mm. */
  double depthMm() {
    return depthMm;
  }

  /** Restores the depth that was valid before steps that are taken back. */
  void setDepthMm(double newDepthMm) {
    depthMm = newDepthMm;
  }

  /** Whether the next step begins with contacts. */
  boolean hasContacts() {
    return kept.count() > 0;
  }

  /**
   * Sets the target of the next steps.
   *
   * @param newMotion gets the committed steps
   */
  void aim(Pose newTarget, ToolMotion newMotion) {
    target = newTarget;
    motion = newMotion;
  }

  /** Returns the distance between the committed pose and the target, mm. */
  double distanceMm() {
    return tool.metric().distance(verifier.pose(), target);
  }

  /**
   * Moves straight towards the target by the whole distance, a half or a quarter, if no leg touches
   * a solid.
   *
   * @param mostMm the longest distance, in the kinetic metric
   * @return whether a step was committed
   */
  boolean stepStraight(double mostMm, double pathMm) {
    pathLeftMm = pathMm;
    aimTwist();
    double farMm = distanceMm();
    double longest = farMm > mostMm ? mostMm / farMm : 1;
    double wholePathMm = twistPathMm();
    if (wholePathMm > pathLeftMm) {
      longest = Math.min(longest, pathLeftMm / wholePathMm);
    }
    if (isBlockedAtContacts()) {
      return false;
    }
    announceHalves(longest, 0.2 * longest);
    for (double fraction = longest; fraction > 0.2 * longest; fraction /= 2) {
      proposeTwist(fraction);
      double shifted = displacement.length() * fraction;
      double turned = turn.length() * fraction;
      boolean isLarge = verifier.limits.hasLargeArcs(shifted, turned);
      if (isFree(shifted, isLarge ? turned : 0, true)) {
        commit();
        return true;
      }
    }
    return false;
  }

  private void aimTwist() {
    verifier.pose().differenceTo(target, displacement, turn, scratch);
  }

  /** Returns a bound of the path of any point in the present twist, mm. */
  private double twistPathMm() {
    return displacement.length() + turn.length() * verifier.radiusMm();
  }

  /**
   * Whether the leg of a kept contact to the target touches a solid. Contacts are the most likely
   * points to touch, so this test comes first.
   */
  private boolean isBlockedAtContacts() {
    verifier.propose(target);
    hits.clear();
    for (int n = 0; n < kept.count(); n++) {
      if (!verifier.isPointFree(kept.body[n], kept.point[n], hits)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Proposes a fraction of the twist towards the target; a fraction of 1 gives exactly the target's
   * bits.
   */
  private void proposeTwist(double fraction) {
    if (fraction == 1) {
      verifier.propose(candidate.set(target));
    } else {
      proposeStep(fraction);
    }
  }

  /** Announces a fraction of the twist and its halves, so that a device judges them together. */
  private void announceHalves(double longest, double least) {
    if (verifier.takesAnnouncements()) {
      for (double fraction = longest; fraction > least; fraction /= 2) {
        proposeTwist(fraction);
        verifier.announce(fraction == longest);
      }
    }
  }

  private boolean isFree(double shifted, double largeTurn, boolean firstOnly) {
    long before = verifier.tested();
    hits.clear();
    boolean free = verifier.isFree(shifted, largeTurn, firstOnly, hits);
    if (free && largeTurn == 0) {
      budget.countVerification(verifier.tested() - before);
    }
    return free;
  }

  private void commit() {
    double lengthMm = stepLengthMm();
    verifier.commit();
    motion.add(candidate, lengthMm);
    pathLeftMm -= lengthMm;
  }

  /** Returns a bound of the path of any point in the proposed step, mm. */
  private double stepLengthMm() {
    verifier.pose().differenceTo(candidate, displacement, turn, scratch);
    return twistPathMm();
  }

  /**
   * Takes one step that the contacts allow.
   *
   * @param riseMm the most that contacts below the surface may rise, and that the step may lead
   *     away from the target, mm
   * @param mostMm the longest step, in the kinetic metric
   * @param pathMm the longest path of a point
   * @param leastPathMm steps with shorter paths are not proposed
   * @return whether a step was committed
   */
  boolean step(double riseMm, double mostMm, double pathMm, double leastPathMm) {
    pathLeftMm = pathMm;
    shortestPathMm = leastPathMm;
    begin(riseMm);
    double fraction = 0;
    for (int n = 0; n < MOST_PROPOSALS && (n == 0 || !budget.isSpent(onFaces)); n++) {
      if (!solve(riseMm)) {
        fraction = 0;
        break;
      }
      fraction = propose(mostMm);
      if (fraction == 0) {
        break;
      }
      if (areContactsFree() && isFree(0, 0, false)) {
        accept(fraction);
        return true;
      }
      if (!addContactsOfHits()) {
        break;
      }
    }
    double part = fraction > 0 && (!onFaces || budget.hasFaces()) ? committedPart(fraction) : 0;
    takeDepth(part);
    keepContacts();
    return part > 0;
  }

  /**
   * Takes one step that the faces of voxels allow, without the smooth surface. Where contacts on
   * the surface contradict each other, there may be room between surface and voxels.
   *
   * @param mostMm the longest step, in the kinetic metric
   * @param pathMm the longest path of a point
   * @return whether a step was committed
   */
  boolean stepOnFaces(double mostMm, double pathMm) {
    onFaces = true;
    boolean stepped = step(0, mostMm, pathMm, SHORTEST_LIFT_EDGES * edgeMm);
    onFaces = false;
    return stepped;
  }

  /**
   * Moves away from opposing contacts, into the middle between them, if no other step leads on. The
   * lift follows the contacts' normals and may lead away from the target. Later steps must make up
   * for that; otherwise the frame is taken back.
   *
   * @param pull the fraction of the distance to the target that is requested at the same time
   * @return whether a step was committed
   */
  boolean lift(double pull, double pathMm) {
    pathLeftMm = pathMm;
    shortestPathMm = SHORTEST_LIFT_EDGES * edgeMm;
    if (!contacts.areOpposed()) {
      return false;
    }
    contacts.setLift(pull);
    budget.countSolve();
    double fraction = contacts.problem.solve() ? propose(Double.POSITIVE_INFINITY) : 0;
    if (fraction == 0) {
      return false;
    }
    if (isFree(0, 0, true)) {
      commit();
      return true;
    }
    return committedPart(fraction) > 0;
  }

  private void begin(double riseMm) {
    contacts.begin(verifier.pose(), depthMm);
    for (int n = 0; n < kept.count() && !onFaces; n++) {
      int before = contacts.count();
      int contact = addKeptSurface(kept.body[n], kept.point[n], riseMm);
      if (contact == before && n < kept.active()) {
        addRollingContact(contact, riseMm);
      }
    }
    aimTwist();
    tool.metric().toMetric(verifier.pose(), displacement, turn, position, metric);
    contacts.setTarget(metric);
  }

  /**
   * Adds a contact for the neighbour of an active contact that lies lowest along the normal, if it
   * lies lower than the contact. So when a curved tool rolls over a surface, the contact passes to
   * the next point before that point meets a voxel.
   */
  private void addRollingContact(int contact, double riseMm) {
    int body = contacts.body[contact];
    Mover points = verifier.pair(body).points;
    Vec3 normal = contacts.normal(contact, position);
    normal.mul(verifier.pushSign(body), normal);
    points.pose.rotation.inverseRotate(normal, normal);
    int lowest =
        SampleNeighbours.lowest(
            points.shape, contacts.point[contact], normal, LOWER_EDGES * edgeMm);
    if (contacts.surfaceContact(body, lowest) < 0) {
      addKeptSurface(body, lowest, riseMm);
    }
  }

  /**
   * Adds a contact with the surface near a point. If the tool is curved there, the contact passes
   * to the sample point that is nearest to it, and contacts at the same place count as one. Returns
   * the index of the contact at that place; -1 if there is no surface.
   */
  private int addKeptSurface(int body, int point, double riseMm) {
    if (!findSurface(body, point)) {
      return -1;
    }
    ContactField field = verifier.field(body);
    if (field.evaluations == 1) {
      return addFound(body, point, riseMm);
    }
    int same = contacts.contactAt(body, own, SAME_PLACE_EDGES * edgeMm);
    if (same >= 0) {
      return same;
    }
    int nearest = SampleNeighbours.nearest(verifier.pair(body).points.shape, point, field.at);
    return addFound(body, contacts.surfaceContact(body, nearest) < 0 ? nearest : point, riseMm);
  }

  private boolean findSurface(int body, int point) {
    ContactField field = verifier.field(body);
    boolean found = field.touch(verifier.pair(body), point);
    budget.countField(field.evaluations);
    verifier.ownPosition(body, field.at, own);
    return found;
  }

  private int addFound(int body, int point, double riseMm) {
    ContactField field = verifier.field(body);
    field.normal.mul(verifier.pushSign(body), push);
    return contacts.addSurface(body, point, own, push, field, riseMm);
  }

  /**
   * Solves for the step. Reduces the rises if the contacts contradict each other or if the solution
   * is worse than staying.
   */
  private boolean solve(double riseMm) {
    budget.countSolve();
    boolean solved = contacts.problem.solve();
    for (int n = 0; n < 6 && (!solved || contacts.isWorseThanStaying(riseMm)); n++) {
      contacts.relaxRises(n == 5);
      budget.countSolve();
      solved = contacts.problem.solve();
    }
    return solved;
  }

  /** Proposes the solution, shortened to the limits of a step; returns the fraction of it, or 0. */
  private double propose(double mostMm) {
    tool.metric().toTwist(verifier.pose(), contacts.problem.y, displacement, turn);
    double path = twistPathMm();
    double longest = Math.min(StepLimits.STEP_EDGES * edgeMm, Math.min(2 * mostMm, pathLeftMm));
    double fraction = verifier.limits.largestPart(displacement.length(), turn.length());
    fraction = Math.min(fraction, path > longest ? longest / path : 1);
    if (path * fraction < shortestPathMm) {
      return 0;
    }
    proposeStep(fraction);
    return fraction;
  }

  private void proposeStep(double fraction) {
    verifier.pose().displace(displacement, turn, fraction, scratch, candidate);
    verifier.mover.snap(candidate);
    verifier.propose(candidate);
  }

  /**
   * Whether the legs of the contacts touch no solid. Cheaper than a test of all points, and finds
   * most hits.
   */
  private boolean areContactsFree() {
    hits.clear();
    for (int c = 0; c < contacts.count() && !hits.isFull(); c++) {
      verifier.isPointFree(contacts.body[c], contacts.point[c], hits);
    }
    return hits.count() == 0;
  }

  private void accept(double fraction) {
    commit();
    takeDepth(fraction);
    keepContacts();
  }

  /** Adds or raises contacts for the earliest hits; returns whether any contact has changed. */
  private boolean addContactsOfHits() {
    boolean changed = false;
    for (int n = 0; n < MOST_NEW_CONTACTS && hits.count() > 0; n++) {
      changed |= addContactOfHit(hits.takeEarliest());
    }
    return changed;
  }

  private boolean addContactOfHit(int hit) {
    if (onFaces) {
      return addFace(hit);
    }
    int body = hits.body[hit];
    int point = hits.point[hit];
    int contact = contacts.surfaceContact(body, point);
    if (contact < 0) {
      contact = findSurface(body, point) ? addFound(body, point, 0) : -1;
      if (contact < 0) {
        return addFace(hit);
      }
      if (contacts.isViolated(contact)) {
        return true;
      }
    }
    return contacts.raise(contact) || addFace(hit);
  }

  private boolean addFace(int hit) {
    int axis = hits.axis[hit];
    if (axis == LegHits.NO_AXIS) {
      return false;
    }
    int body = hits.body[hit];
    position.set(0, 0, 0);
    position.set(axis, hits.side[hit]);
    BodyVerifier pair = verifier.pair(body);
    double keptMm = pair.levels.reachMm(pair.level(hits.point[hit]), position);
    pair.solid.body.gridDirectionToWorld(position, push);
    push.mul(verifier.pushSign(body), push);
    verifier.ownPosition(body, pair.points.shape.point(hits.point[hit], position), own);
    return contacts.addFace(body, hits.point[hit], own, push, hits.gapMm[hit], keptMm);
  }

  /** Takes a part of the depth of the solution; faces have none, so the depth stays. */
  private void takeDepth(double part) {
    depthMm += onFaces ? 0 : part * (contacts.solvedDepthMm() - depthMm);
  }

  /** Commits a shorter part of the last proposal if one is free; returns it, or 0. */
  private double committedPart(double fraction) {
    announceHalves(0.5 * fraction, SMALLEST_FRACTION * fraction);
    for (double part = 0.5 * fraction; part > SMALLEST_FRACTION * fraction; part /= 2) {
      proposeStep(part);
      if (isFree(0, 0, true)) {
        commit();
        return part;
      }
    }
    return 0;
  }

  /** Keeps active contacts first, then those that are near. */
  private void keepContacts() {
    kept.clear();
    motion.contacts.clear();
    for (int c = 0; c < contacts.count(); c++) {
      double multiplier = contacts.multiplier(c);
      if (multiplier >= 0) {
        kept.add(contacts.body[c], contacts.point[c]);
        motion.contacts.add(
            verifier.other(contacts.body[c]),
            contacts.at(c, own),
            contacts.normal(c, position),
            contacts.heightMm(c),
            multiplier);
      }
    }
    kept.endActive();
    motion.contacts.normalizeShares();
    for (int c = 0; c < contacts.count(); c++) {
      if (contacts.isNear(c)) {
        kept.add(contacts.body[c], contacts.point[c]);
      }
    }
  }
}
