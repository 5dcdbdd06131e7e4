package org.palpate.rigid.skip;

import org.palpate.body.SolidHeights;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.volume.BitCube;

/**
 * Finds sample points that stay above all solids around them while they move, so that their legs
 * need no test. Above is along the normal of a contact. A face that lies flat on a surface has
 * thousands of points near solids. Nearly all of them stay above the solids around their leaf.
 *
 * <p>A leg from one point above a plane to another stays above it. Let a box hold a node at both
 * poses. The legs of the node are free if the node is at both poses above the highest solid in the
 * box. Heights allow for rounding. Between rough faces this may cost more than it saves; {@link
 * ScreenTrial} finds that out.
 *
 * <p>The answers change no result, only the work. Haptic thread only; allocates nothing.
 */
public final class HeightScreen {
  /** A direction is kept while some contact's normal is within this angle: its cosine. */
  private static final double SAME_DIRECTION_COSINE = Math.cos(0.03);

  /** After this many normals in a row that are not near the direction, the next one replaces it. */
  private static final int MOST_OTHERS = 16;

  /** A node with several leaves that is not above is not tested in this many verifications. */
  private static final byte NODE_WAIT = 16;

  private final RigidTool tool;
  private final SphereTree tree;
  private final Vec3 cellMm;
  private final SolidHeights heights;
  private final Vec3 normal = new Vec3();
  private final Vec3 direction = new Vec3();
  private final MovingHeight atStart = new MovingHeight();
  private final MovingHeight atEnd = new MovingHeight();
  private boolean hasNormal;
  private int others;
  private long versionSeen;
  private boolean isOn;

  /** The number of verifications in which each node is still left untested. */
  private final byte[] wait;

  private final ScreenTrial trial = new ScreenTrial();

  private double roundingCells;

  /** The height of the solids around the node that was tested last. */
  private double ground = Double.POSITIVE_INFINITY;

  /** The pose of the points at one end of a motion, and their heights there. */
  private final class MovingHeight {
    private AffineMap map;
    private double x;
    private double y;
    private double z;
    private double offset;
    private double middleX;
    private double middleY;
    private double middleZ;
    private double halfX;
    private double halfY;
    private double halfZ;

    void set(AffineMap toCells) {
      map = toCells;
      Vec3 d = direction;
      x = d.x * map.mXX + d.y * map.mYX + d.z * map.mZX;
      y = d.x * map.mXY + d.y * map.mYY + d.z * map.mZY;
      z = d.x * map.mXZ + d.y * map.mYZ + d.z * map.mZZ;
      offset = d.x * map.offsetX + d.y * map.offsetY + d.z * map.offsetZ;
    }

    double of(double a, double b, double c) {
      return x * a + y * b + z * c + offset;
    }

    /** Returns the height of the lowest point of a node's box. */
    double lowest(int node) {
      return of(tree.x(node), tree.y(node), tree.z(node))
          - Math.abs(x) * tree.halfX(node)
          - Math.abs(y) * tree.halfY(node)
          - Math.abs(z) * tree.halfZ(node);
    }

    /** Finds a box in cells that holds the box of a node. */
    void cover(int node) {
      double a = tree.halfX(node);
      double b = tree.halfY(node);
      double c = tree.halfZ(node);
      middleX = map.x(tree.x(node), tree.y(node), tree.z(node));
      middleY = map.y(tree.x(node), tree.y(node), tree.z(node));
      middleZ = map.z(tree.x(node), tree.y(node), tree.z(node));
      halfX = Math.abs(map.mXX) * a + Math.abs(map.mXY) * b + Math.abs(map.mXZ) * c;
      halfY = Math.abs(map.mYX) * a + Math.abs(map.mYY) * b + Math.abs(map.mYZ) * c;
      halfZ = Math.abs(map.mZX) * a + Math.abs(map.mZY) * b + Math.abs(map.mZZ) * c;
    }
  }

  /**
   * Creates a screen without a direction, which finds nothing.
   *
   * @param tool the tool whose points are screened
   * @param solids the cube whose solids the points must not touch
   * @param cellMm the edges of its cells, mm
   */
  public HeightScreen(RigidTool tool, BitCube solids, Vec3 cellMm) {
    this.tool = tool;
    this.cellMm = cellMm;
    tree = tool.tree();
    wait = new byte[tree.nodes()];
    heights = new SolidHeights(solids);
  }

  /**
   * Suggests the normal of a contact as the direction.
   *
   * @param alongAxes the normal, a unit vector in mm along the axes of the body's grid, away from
   *     the solid
   */
  public void suggest(Vec3 alongAxes) {
    if (hasNormal && normal.dot(alongAxes) >= SAME_DIRECTION_COSINE) {
      others = 0;
      return;
    }
    if (hasNormal && others++ < MOST_OTHERS) {
      return;
    }
    others = 0;
    hasNormal = true;
    normal.set(alongAxes);
    for (int axis = 0; axis < 3; axis++) {
      direction.set(axis, normal.get(axis) * cellMm.get(axis));
    }
    direction.mul(1 / direction.length(), direction);
    heights.setDirection(direction.x, direction.y, direction.z);
  }

  /**
   * Begins the verification of a motion.
   *
   * @param from the map from the points' frame to cells at the start
   * @param to the same map at the end
   * @param rounding the allowance for the rounding of coordinates, cells
   * @param version the version of the solids, which changes with them
   */
  public void begin(AffineMap from, AffineMap to, double rounding, long version) {
    ground = Double.POSITIVE_INFINITY;
    isOn = hasNormal;
    if (!isOn) {
      return;
    }
    if (versionSeen != version) {
      versionSeen = version;
      heights.forget();
    }
    trial.begin();
    roundingCells = rounding;
    atStart.set(from);
    atEnd.set(to);
  }

  /** Ends a verification; nothing is known to be above any more. */
  public void end() {
    if (isOn) {
      trial.end();
    }
    isOn = false;
    ground = Double.POSITIVE_INFINITY;
  }

  /**
   * {@return whether all points of a node stay above the solids around them}
   *
   * @param node the number of the node in the tool's tree
   */
  public boolean isAbove(int node) {
    if (!isOn) {
      return false;
    }
    int points = tree.isLeaf(node) ? tree.end(node) - tree.first(node) : 0;
    trial.comeTo(points);
    if (!trial.asks()) {
      ground = Double.POSITIVE_INFINITY;
      return false;
    }
    if (wait[node] > 0) {
      wait[node]--;
      ground = Double.POSITIVE_INFINITY;
      return false;
    }
    trial.countAnswer();
    atStart.cover(node);
    atEnd.cover(node);
    double most =
        heights.most(
            Math.min(atStart.middleX - atStart.halfX, atEnd.middleX - atEnd.halfX) - roundingCells,
            Math.min(atStart.middleY - atStart.halfY, atEnd.middleY - atEnd.halfY) - roundingCells,
            Math.min(atStart.middleZ - atStart.halfZ, atEnd.middleZ - atEnd.halfZ) - roundingCells,
            Math.max(atStart.middleX + atStart.halfX, atEnd.middleX + atEnd.halfX) + roundingCells,
            Math.max(atStart.middleY + atStart.halfY, atEnd.middleY + atEnd.halfY) + roundingCells,
            Math.max(atStart.middleZ + atStart.halfZ, atEnd.middleZ + atEnd.halfZ) + roundingCells);
    ground = most + 2 * roundingCells;
    boolean isAbove = atStart.lowest(node) > ground && atEnd.lowest(node) > ground;
    if (!isAbove) {
      trial.countPoints(points);
      wait[node] = tree.isLeaf(node) ? 0 : NODE_WAIT;
    }
    return isAbove;
  }

  /**
   * {@return whether a point of the node that was tested last stays above the solids around it}
   *
   * @param n the index of the point
   */
  public boolean isPointAbove(int n) {
    return ground < Double.POSITIVE_INFINITY
        && atStart.of(tool.x(n), tool.y(n), tool.z(n)) > ground
        && atEnd.of(tool.x(n), tool.y(n), tool.z(n)) > ground;
  }
}
