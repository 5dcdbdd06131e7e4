package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * The contacts of a step as rows of a nearest-point problem in seven unknowns: the six metric
 * coordinates of the step, and how far below the isosurface the contacts may run ("depth").
 *
 * <p>A surface contact asks its point to stay above the isosurface less the depth, to first order.
 * Depth has a price, so it is 0 unless it buys a larger approach to the device: in the open it
 * never does, between opposing walls it does. The depth is continuous; so is the change from
 * surface to voxels. A contact whose leg has hit a voxel all the same is raised by hard steps, and
 * at last becomes a contact with the face of the voxel.
 *
 * <p>Reference: constraint-based six-degree-of-freedom god object, Ortega, Redon and Coquillart
 * 2007; the metric is theirs, the surface and the depth are ours. Haptic thread only.
 */
final class ContactRows {
  static final int CAPACITY = 96;

  private static final int UNKNOWNS = 7;
  private static final int DEPTH = 6;

  /** Rows for the least and the largest depth come first. */
  private static final int FIRST = 2;

  /** The largest depth, edges: from the isosurface down to the bare voxels and a little more. */
  static final double LARGEST_DEPTH_EDGES = 1.2;

  /**
   * The price of an edge of depth, relative to an edge of distance from the device. It is more than
   * 1, so that pressing on an open surface does not pay.
   */
  static final double DEPTH_PRICE = 1.3;

  /** Curvature of the price, so that the problem is strictly convex. */
  private static final double DEPTH_STIFFNESS = 0.3;

  /** The margin that a relief asks for, edges, and its weight against the length of the motion. */
  private static final double RELIEF_EDGES = 0.6;

  private static final double RELIEF_WEIGHT = 3;

  /** By how much a point is raised when its leg has hit, edges, one time after the other. */
  private static final double[] RAISES_EDGES = {.02, .08, .2, .4, .7, 1.1};

  /** A contact counts as pressed if its height is below this, edges. */
  private static final double NEAR_EDGES = 0.3;

  final int[] body = new int[CAPACITY];
  final int[] point = new int[CAPACITY];
  final NearestPointSolver problem = new NearestPointSolver(UNKNOWNS, CAPACITY + FIRST);

  private final double[] normalX = new double[CAPACITY];
  private final double[] normalY = new double[CAPACITY];
  private final double[] normalZ = new double[CAPACITY];
  private final double[] heightMm = new double[CAPACITY];
  private final int[] raises = new int[CAPACITY];
  private final boolean[] face = new boolean[CAPACITY];
  private final RigidTool tool;
  private final double edgeMm;
  private final Vec3 normal = new Vec3();
  private final Vec3 scratch = new Vec3();
  private Pose pose;
  private double depthMm;
  private int count;

  ContactRows(RigidTool tool, double edgeMm) {
    this.tool = tool;
    this.edgeMm = edgeMm;
  }

  /**
   * Begins a step without contacts.
   *
   * @param from the pose from which the step leads; kept
   * @param presentDepthMm the depth of the present contacts
   */
  void begin(Pose from, double presentDepthMm) {
    pose = from;
    depthMm = presentDepthMm;
    count = 0;
    problem.rows = FIRST;
    Arrays.fill(problem.a, 0, FIRST * UNKNOWNS, 0);
    problem.a[DEPTH] = 1;
    problem.b[0] = 0;
    problem.a[UNKNOWNS + DEPTH] = -1;
    problem.b[1] = -DEPTH_STIFFNESS * LARGEST_DEPTH_EDGES * edgeMm;
  }

  int count() {
    return count;
  }

  /** Sets where the step should lead: six metric coordinates, mm. */
  void setTarget(double[] metric) {
    double square = 0;
    for (int c = 0; c < DEPTH; c++) {
      problem.target[c] = metric[c];
      square += metric[c] * metric[c];
    }
    problem.target[DEPTH] = -DEPTH_PRICE * Math.sqrt(square) / DEPTH_STIFFNESS;
  }

  /** Returns the contact of a point with the surface of a body, or -1. */
  int surfaceContact(int ofBody, int ofPoint) {
    for (int c = 0; c < count; c++) {
      if (point[c] == ofPoint && body[c] == ofBody && !face[c]) {
        return c;
      }
    }
    return -1;
  }

  /**
   * Adds a contact with the surface that a field has just evaluated at the point.
   *
   * @param mostRiseMm by how much a point deeper than the present depth must rise at most
   * @return its index, or -1 if there is no room
   */
  int addSurface(int ofBody, int ofPoint, ContactField field, double mostRiseMm) {
    int c = add(ofBody, ofPoint, field.normal, false);
    if (c >= 0) {
      heightMm[c] = field.heightMm;
      problem.b[row(c)] = Math.min(-field.heightMm, depthMm + mostRiseMm);
      problem.a[row(c) * UNKNOWNS + DEPTH] = 1 / DEPTH_STIFFNESS;
    }
    return c;
  }

  /** Adds a contact with the face of a voxel; the normal is unit, world axes. */
  boolean addFace(int ofBody, int ofPoint, Vec3 faceNormal, double gapMm) {
    double need = Math.min(0, SHORT_OF_FACE_EDGES * edgeMm - gapMm);
    for (int c = 0; c < count; c++) {
      if (face[c] && point[c] == ofPoint && body[c] == ofBody && isAlong(c, faceNormal)) {
        problem.b[row(c)] = Math.max(need, problem.b[row(c)]) + 1e-3 * edgeMm;
        return raises[c]++ < 3;
      }
    }
    int c = add(ofBody, ofPoint, faceNormal, true);
    if (c < 0) {
      return false;
    }
    heightMm[c] = gapMm;
    problem.b[row(c)] = need;
    return true;
  }

  /** Points stop this far before the face of a voxel. */
  private static final double SHORT_OF_FACE_EDGES = 0x1p-18;

  private boolean isAlong(int c, Vec3 direction) {
    return normalX[c] * direction.x + normalY[c] * direction.y + normalZ[c] * direction.z > 0.99;
  }

  private int add(int ofBody, int ofPoint, Vec3 n, boolean isFace) {
    if (count == CAPACITY) {
      return -1;
    }
    int c = count++;
    body[c] = ofBody;
    point[c] = ofPoint;
    face[c] = isFace;
    raises[c] = 0;
    normalX[c] = n.x;
    normalY[c] = n.y;
    normalZ[c] = n.z;
    double x = tool.x(ofPoint);
    double y = tool.y(ofPoint);
    double z = tool.z(ofPoint);
    int at = row(c) * UNKNOWNS;
    tool.metric().contactRow(pose, x, y, z, n, scratch, problem.a, at);
    problem.a[at + DEPTH] = 0;
    problem.rows = row(count);
    return c;
  }

  private static int row(int contact) {
    return contact + FIRST;
  }

  /**
   * Raises the point of a surface contact beyond what the last solution gave it.
   *
   * @return false if it was raised as often as makes sense
   */
  boolean raise(int c) {
    if (raises[c] == RAISES_EDGES.length) {
      return false;
    }
    problem.a[row(c) * UNKNOWNS + DEPTH] = 0;
    problem.b[row(c)] = Math.max(0, problem.b[row(c)]) + RAISES_EDGES[raises[c]++] * edgeMm;
    return true;
  }

  /** Whether the last solution left the point of a contact lower than the contact asks for. */
  boolean isUnmet(int c) {
    return problem.along(row(c)) < problem.b[row(c)] - 1e-3 * edgeMm;
  }

  /** Halves all rises; with {@code none}, lets no contact ask for a rise. */
  void softenRises(boolean none) {
    for (int c = 0; c < count; c++) {
      double need = problem.b[row(c)];
      boolean isHard = problem.a[row(c) * UNKNOWNS + DEPTH] == 0;
      double kept = isHard ? 0 : depthMm;
      if (need > kept) {
        problem.b[row(c)] = none ? kept : kept + 0.5 * (need - kept);
      }
    }
  }

  /** Returns the depth of the last solution, mm. */
  double solvedDepthMm() {
    return Math.max(0, problem.y[DEPTH] / DEPTH_STIFFNESS);
  }

  /**
   * Whether the last solution is farther from the target, depth counted, than staying is.
   *
   * @param allowedMm by how much it may be farther
   */
  boolean isWorseThanStaying(double allowedMm) {
    double stay = priced(depthMm);
    double go = priced(solvedDepthMm());
    for (int c = 0; c < DEPTH; c++) {
      double left = problem.y[c] - problem.target[c];
      stay += problem.target[c] * problem.target[c];
      go += left * left;
    }
    double most = Math.sqrt(Math.max(0, stay)) + allowedMm;
    return go > most * most * (1 - 1e-9) && go > 1e-18;
  }

  private double priced(double depth) {
    double off = depth * DEPTH_STIFFNESS - problem.target[DEPTH];
    return off * off - problem.target[DEPTH] * problem.target[DEPTH];
  }

  /**
   * Turns the problem of a step into that of a relief: to find the motion that gives all contacts
   * the largest common margin, for its length. Between opposing contacts that leads to the middle.
   * The last unknown is then the margin; contacts that contradict each other get a negative one.
   *
   * @param pull which fraction of the way to the target is asked for at the same time
   */
  void setRelief(double pull) {
    Arrays.fill(problem.a, 0, FIRST * UNKNOWNS, 0);
    Arrays.fill(problem.b, 0, FIRST, -1);
    for (int c = 0; c < count; c++) {
      problem.a[row(c) * UNKNOWNS + DEPTH] = -1 / RELIEF_WEIGHT;
    }
    for (int c = 0; c < DEPTH; c++) {
      problem.target[c] *= pull;
    }
    problem.target[DEPTH] = RELIEF_WEIGHT * RELIEF_EDGES * edgeMm;
  }

  /** Whether a contact was met with equality by the last solution. */
  boolean isActive(int c) {
    for (int n = 0; n < problem.activeCount; n++) {
      if (problem.active[n] == row(c)) {
        return true;
      }
    }
    return false;
  }

  /** Whether the point of a contact is near the surface or the face. */
  boolean isNear(int c) {
    return heightMm[c] < NEAR_EDGES * edgeMm;
  }

  /** Writes the normal of a contact, unit, world axes. */
  Vec3 normal(int c, Vec3 dest) {
    return dest.set(normalX[c], normalY[c], normalZ[c]);
  }

  /** Whether two near contacts push against each other. */
  boolean areOpposed() {
    for (int a = 0; a < count; a++) {
      for (int b = 0; isNear(a) && b < a; b++) {
        normal.set(normalX[b], normalY[b], normalZ[b]);
        double cosine = normalX[a] * normal.x + normalY[a] * normal.y + normalZ[a] * normal.z;
        if (isNear(b) && cosine < -0.3) {
          return true;
        }
      }
    }
    return false;
  }
}
