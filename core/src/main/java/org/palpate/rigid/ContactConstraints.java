package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.KineticMetric;

/**
 * The contacts of a step as linear constraints of a nearest-point problem. It has seven unknowns:
 * the six metric coordinates of the step, and the depth to which contacts may sink below the
 * isosurface.
 *
 * <p>A surface contact requires that its point stays above the isosurface less the depth, to first
 * order. Depth costs more than distance from the device, so it is 0 unless it allows a larger
 * approach. On an open surface it never does; between opposing walls it does. Depth is continuous,
 * so a contact does not jump from the surface to the voxels. If the leg of a contact hits a voxel
 * nevertheless, the height that the contact requires is raised step by step. After the last raise,
 * or earlier if the contact cannot rise so far, a contact with the face of the voxel is added.
 *
 * <p>Reference: constraint-based six-degree-of-freedom god object, Ortega, Redon and Coquillart
 * 2007. The metric is theirs; surface and depth are added here. Haptic thread only; allocates
 * nothing.
 */
final class ContactConstraints {
  static final int CAPACITY = 96;

  /** The distance beyond which a target is replaced by a nearer one, edges, against rounding. */
  private static final double FARTHEST_TARGET_EDGES = 1000;

  private static final int UNKNOWNS = 7;
  private static final int DEPTH = 6;

  /** The rows before the contacts: they bound the depth from below and above. */
  private static final int DEPTH_ROWS = 2;

  /**
   * The largest depth, edges: it reaches from the isosurface to a little below the voxels' faces.
   */
  static final double LARGEST_DEPTH_EDGES = 1.2;

  /**
   * The cost of depth relative to the cost of an equal distance from the device. It is more than 1,
   * so that pressing on an open surface causes no depth.
   */
  static final double DEPTH_COST = 1.3;

  /** The scale of the unknown for depth; a quadratic cost keeps the problem strictly convex. */
  private static final double DEPTH_SCALE = 0.3;

  /** The gap that a lift between opposing contacts aims at, edges. */
  private static final double LIFT_EDGES = 0.6;

  /** The weight of that gap against the length of the motion. */
  private static final double LIFT_WEIGHT = 3;

  /** The heights by which a contact is raised after each hit of its leg, edges. */
  private static final double[] RAISES_EDGES = {.02, .08, .2, .4, .7, 1.1};

  /**
   * A contact that was raised at least so often is not raised again once its rise is reduced. With
   * a larger number the raises use up the proposals of a step, and a peg can stand on the rim of
   * its hole for good. With a smaller one the step to the voxel's face is felt: a burr vibrates
   * while it cuts. Both were tried; see docs/results/rigid.md.
   */
  private static final int RAISES_BEFORE_FACE = 4;

  /** Points stop this far before the face of a voxel, edges. */
  private static final double SHORT_OF_FACE_EDGES = 0x1p-18;

  /** The length by which a contact with a face is tightened after each hit, edges. */
  private static final double TIGHTEN_EDGES = 1e-3;

  /** The most times that a contact with a face is tightened. */
  private static final int MOST_TIGHTENINGS = 3;

  /** A contact is violated if its point is this much lower than required, edges. */
  private static final double VIOLATED_EDGES = 1e-3;

  /** Two normals with a larger cosine belong to the same face. */
  private static final double SAME_FACE_COSINE = 0.99;

  /** The normals of two contacts with a smaller cosine point against each other. */
  private static final double OPPOSED_COSINE = -0.3;

  /** Two normals with a smaller cosine push apart, as those on the faces of two teeth do. */
  private static final double APART_COSINE = 0.5;

  /** A contact is near if its point is lower than this over the surface, edges. */
  private static final double NEAR_EDGES = 0.3;

  /** The number of the pair; the point belongs to whichever of the two carries points. */
  final int[] body = new int[CAPACITY];

  final int[] point = new int[CAPACITY];
  final NearestPointSolver problem = new NearestPointSolver(UNKNOWNS, CAPACITY + DEPTH_ROWS);

  private final double[] normalX = new double[CAPACITY];
  private final double[] normalY = new double[CAPACITY];
  private final double[] normalZ = new double[CAPACITY];
  private final double[] atX = new double[CAPACITY];
  private final double[] atY = new double[CAPACITY];
  private final double[] atZ = new double[CAPACITY];
  private final double[] heightMm = new double[CAPACITY];
  private final double[] clearanceMm = new double[CAPACITY];
  private final int[] raises = new int[CAPACITY];
  private final boolean[] face = new boolean[CAPACITY];
  private final KineticMetric metric;
  private final double edgeMm;
  private final Vec3 normal = new Vec3();
  private final Vec3 scratch = new Vec3();
  private Pose pose;
  private double depthMm;
  private int count;

  ContactConstraints(KineticMetric metric, double edgeMm) {
    this.metric = metric;
    this.edgeMm = edgeMm;
  }

  /**
   * Begins a step without contacts.
   *
   * @param from the pose at which the step begins; kept
   * @param presentDepthMm the depth of the present contacts, mm
   */
  void begin(Pose from, double presentDepthMm) {
    pose = from;
    depthMm = presentDepthMm;
    count = 0;
    problem.rows = DEPTH_ROWS;
    Arrays.fill(problem.a, 0, DEPTH_ROWS * UNKNOWNS, 0);
    problem.a[DEPTH] = 1;
    problem.b[0] = 0;
    problem.a[UNKNOWNS + DEPTH] = -1;
    problem.b[1] = -DEPTH_SCALE * LARGEST_DEPTH_EDGES * edgeMm;
  }

  int count() {
    return count;
  }

  /**
   * Sets the motion to the device. One that is too long is shortened.
   *
   * @param metric six metric coordinates, mm
   */
  void setTarget(double[] metric) {
    double square = 0;
    for (int c = 0; c < DEPTH; c++) {
      square += metric[c] * metric[c];
    }
    double farthest = FARTHEST_TARGET_EDGES * edgeMm;
    double part = square > farthest * farthest ? farthest / Math.sqrt(square) : 1;
    square = 0;
    for (int c = 0; c < DEPTH; c++) {
      problem.target[c] = metric[c] * part;
      square += problem.target[c] * problem.target[c];
    }
    problem.target[DEPTH] = -DEPTH_COST * Math.sqrt(square) / DEPTH_SCALE;
  }

  /** Returns the index of the contact of a point with the surface of a body, or -1. */
  int surfaceContact(int ofBody, int ofPoint) {
    for (int c = 0; c < count; c++) {
      if (point[c] == ofPoint && body[c] == ofBody && !face[c]) {
        return c;
      }
    }
    return -1;
  }

  /** Returns the index of a surface contact with a body near a position, or -1 if there is none. */
  int contactAt(int ofBody, Vec3 at, double withinMm) {
    for (int c = 0; c < count; c++) {
      double square = at(c, scratch).sub(at, scratch).dot(scratch);
      if (body[c] == ofBody && !face[c] && square < withinMm * withinMm) {
        return c;
      }
    }
    return -1;
  }

  /**
   * Adds a contact with the surface at a point.
   *
   * @param at the point in the frame of what moves, mm
   * @param push unit, world axes: the normal along which the contact pushes what moves
   * @param surface the surface that was found near the point
   * @param mostRiseMm the most that a point below the present depth is required to rise, mm
   * @return its index, or -1 if there are too many contacts
   */
  int addSurface(
      int ofBody, int ofPoint, Vec3 at, Vec3 push, ContactField surface, double mostRiseMm) {
    int c = add(ofBody, ofPoint, at, push, false);
    if (c >= 0) {
      clearanceMm[c] = surface.clearanceMm;
      heightMm[c] = surface.heightMm;
      problem.b[row(c)] = Math.min(-surface.heightMm, depthMm + mostRiseMm);
      problem.a[row(c) * UNKNOWNS + DEPTH] = 1 / DEPTH_SCALE;
    }
    return c;
  }

  /**
   * Adds a contact with the face of a voxel, or tightens it.
   *
   * @param at the point in the frame of what moves, mm
   * @param faceNormal unit, world axes: the normal along which the contact pushes what moves
   * @param gapMm the distance of the point from the face, mm
   * @param keptMm the distance of the face from the body's own voxel, mm
   * @return whether the contact is new or tighter
   */
  boolean addFace(int ofBody, int ofPoint, Vec3 at, Vec3 faceNormal, double gapMm, double keptMm) {
    double need = Math.min(0, SHORT_OF_FACE_EDGES * edgeMm - gapMm);
    for (int c = 0; c < count; c++) {
      if (face[c]
          && point[c] == ofPoint
          && body[c] == ofBody
          && cosine(c, faceNormal) > SAME_FACE_COSINE) {
        problem.b[row(c)] = Math.max(need, problem.b[row(c)]) + TIGHTEN_EDGES * edgeMm;
        return raises[c]++ < MOST_TIGHTENINGS;
      }
    }
    int c = add(ofBody, ofPoint, at, faceNormal, true);
    if (c < 0) {
      return false;
    }
    heightMm[c] = gapMm;
    clearanceMm[c] = keptMm;
    problem.b[row(c)] = need;
    return true;
  }

  /** Returns the cosine of the angle between the normal of a contact and a unit direction. */
  private double cosine(int c, Vec3 direction) {
    return normalX[c] * direction.x + normalY[c] * direction.y + normalZ[c] * direction.z;
  }

  private int add(int ofBody, int ofPoint, Vec3 at, Vec3 n, boolean isFace) {
    if (count == CAPACITY) {
      return -1;
    }
    int c = count++;
    body[c] = ofBody;
    point[c] = ofPoint;
    face[c] = isFace;
    raises[c] = 0;
    atX[c] = at.x;
    atY[c] = at.y;
    atZ[c] = at.z;
    normalX[c] = n.x;
    normalY[c] = n.y;
    normalZ[c] = n.z;
    int first = row(c) * UNKNOWNS;
    metric.contactRow(pose, at.x, at.y, at.z, n, scratch, problem.a, first);
    problem.a[first + DEPTH] = 0;
    problem.rows = row(count);
    return c;
  }

  private static int row(int contact) {
    return contact + DEPTH_ROWS;
  }

  /**
   * Raises the height that a surface contact requires, because its leg has hit a voxel.
   *
   * @return false if it was raised by all of {@link #RAISES_EDGES} before, or raised often and then
   *     reduced
   */
  boolean raise(int c) {
    if (raises[c] == RAISES_EDGES.length) {
      return false;
    }
    problem.a[row(c) * UNKNOWNS + DEPTH] = 0;
    problem.b[row(c)] = Math.max(0, problem.b[row(c)]) + RAISES_EDGES[raises[c]++] * edgeMm;
    return true;
  }

  /** Returns the height of a contact over the body's own surface after the last solution, mm. */
  double heightMm(int c) {
    return clearanceMm[c] + Math.max(0, heightMm[c] + problem.along(row(c)));
  }

  /** Whether the last solution violates a contact. */
  boolean isViolated(int c) {
    return problem.along(row(c)) < problem.b[row(c)] - VIOLATED_EDGES * edgeMm;
  }

  /**
   * Halves the rises that contacts require; with {@code none}, lets none require a rise. A surface
   * contact that was raised often and whose rise is reduced is not raised again, because that would
   * be reduced as well: if its leg still hits a voxel, a contact with the face must follow.
   */
  void relaxRises(boolean none) {
    for (int c = 0; c < count; c++) {
      double need = problem.b[row(c)];
      boolean isHard = problem.a[row(c) * UNKNOWNS + DEPTH] == 0;
      double kept = isHard ? 0 : depthMm;
      if (need > kept) {
        if (!face[c] && raises[c] >= RAISES_BEFORE_FACE) {
          raises[c] = RAISES_EDGES.length;
        }
        problem.b[row(c)] = none ? kept : kept + 0.5 * (need - kept);
      }
    }
  }

  /** Returns the depth of the last solution, mm. */
  double solvedDepthMm() {
    return Math.max(0, problem.y[DEPTH] / DEPTH_SCALE);
  }

  /**
   * Whether the last solution costs more than staying: distance from the target and depth.
   *
   * @param allowedMm the excess that is allowed, mm
   */
  boolean isWorseThanStaying(double allowedMm) {
    double stay = cost(depthMm);
    double go = cost(solvedDepthMm());
    for (int c = 0; c < DEPTH; c++) {
      double left = problem.y[c] - problem.target[c];
      stay += problem.target[c] * problem.target[c];
      go += left * left;
    }
    double most = Math.sqrt(Math.max(0, stay)) + allowedMm;
    return go > most * most * (1 - 1e-9) && go > 1e-18;
  }

  private double cost(double depth) {
    double off = depth * DEPTH_SCALE - problem.target[DEPTH];
    return off * off - problem.target[DEPTH] * problem.target[DEPTH];
  }

  /**
   * Turns the problem of a step into that of a lift: to find a short motion that gives all contacts
   * a large common gap. Between opposing contacts it leads to the middle. The last unknown is then
   * the gap, which is negative if the contacts contradict each other.
   *
   * @param pull the fraction of the motion to the target that is requested at the same time
   */
  void setLift(double pull) {
    Arrays.fill(problem.a, 0, DEPTH_ROWS * UNKNOWNS, 0);
    Arrays.fill(problem.b, 0, DEPTH_ROWS, -1);
    for (int c = 0; c < count; c++) {
      problem.a[row(c) * UNKNOWNS + DEPTH] = -1 / LIFT_WEIGHT;
    }
    for (int c = 0; c < DEPTH; c++) {
      problem.target[c] *= pull;
    }
    problem.target[DEPTH] = LIFT_WEIGHT * LIFT_EDGES * edgeMm;
  }

  /**
   * Returns the length, mm, by which an active contact pushes the last solution along its normal;
   * -1 if the contact is not active: not met with equality.
   */
  double multiplier(int c) {
    for (int n = 0; n < problem.activeCount; n++) {
      if (problem.active[n] == row(c)) {
        return problem.multiplier[n];
      }
    }
    return -1;
  }

  /** Whether the point of a contact is near the surface or the face. */
  boolean isNear(int c) {
    return heightMm[c] < NEAR_EDGES * edgeMm;
  }

  /** Writes where a contact touches, in the frame of what moves, mm. */
  Vec3 at(int c, Vec3 dest) {
    return dest.set(atX[c], atY[c], atZ[c]);
  }

  /** Writes the normal along which a contact pushes what moves, unit, world axes. */
  Vec3 normal(int c, Vec3 dest) {
    return dest.set(normalX[c], normalY[c], normalZ[c]);
  }

  /** Whether the normals of two near contacts point against each other. */
  boolean areOpposed() {
    return hasNearNormals(OPPOSED_COSINE);
  }

  /** Whether the normals of two near contacts differ as on the faces of teeth or of a corner. */
  boolean pushApart() {
    return hasNearNormals(APART_COSINE);
  }

  /** Whether the cosine of the angle between the normals of two near contacts is less. */
  private boolean hasNearNormals(double mostCosine) {
    for (int a = 0; a < count; a++) {
      for (int b = 0; isNear(a) && b < a; b++) {
        if (isNear(b) && cosine(a, normal(b, normal)) < mostCosine) {
          return true;
        }
      }
    }
    return false;
  }
}
