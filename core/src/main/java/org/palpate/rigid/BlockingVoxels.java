package org.palpate.rigid;

import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.collision.EmptyBox;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.volume.BitCube;

/**
 * Finds the voxels that keep a tool from moving on towards its device pose. A voxel blocks the tool
 * exactly if the leg of a sample point touches the voxel, or a cell that the voxel makes solid at
 * the clearance level of that point. Exact arithmetic decides whether a leg touches a cell.
 *
 * <p>The legs lead from the tool pose towards the device pose, as far as no point moves more than
 * two of the shortest voxel edges of the scene. The surface on which a tool rests lies up to about
 * one edge above the cells. The tool gets no farther before the next frame asks again, and this
 * bounds the work. Of each leg only the first solid cell counts, so voxels behind others are found
 * when those are gone. Haptic thread only; allocates nothing.
 */
public final class BlockingVoxels {
  /** The longest motion of a point towards the device pose, shortest voxel edges. */
  static final double REACH_EDGES = 2;

  /** The frame of a grid may differ from an orthonormal one by less than this factor. */
  private static final double FAR_FACTOR = 1.01;

  /** The most cells whose voxels are reported at once, the nearest ones. */
  static final int MOST_CELLS = 64;

  /** Takes voxels. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Takes a voxel.
     *
     * @param body index of its body
     * @param i the voxel's number along x
     * @param j its number along y
     * @param k its number along z
     * @return whether further voxels are wanted
     */
    boolean take(int body, int i, int j, int k);
  }

  private final BodyScene scene;
  private final RigidTool tool;
  private final SphereTree tree;
  private final MoverVerifier verifier;
  private final double reachMm;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray leg = new Ray();
  private final RayHit hit = new RayHit();
  private final AffineMap toGrid = new AffineMap();
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Pose next = new Pose();
  private final Vec3 displacement = new Vec3();
  private final Vec3 rotation = new Vec3();
  private final Quaternion scratch = new Quaternion();

  /** The nearest cells that were found so far, in no order: where their legs meet them. */
  private final double[] t = new double[MOST_CELLS];

  /** The numbers of the legs that found them, in the order in which legs were cast. */
  private final int[] found = new int[MOST_CELLS];

  private final int[] body = new int[MOST_CELLS];
  private final int[] level = new int[MOST_CELLS];
  private final int[] cellX = new int[MOST_CELLS];
  private final int[] cellY = new int[MOST_CELLS];
  private final int[] cellZ = new int[MOST_CELLS];
  private int count;
  private int hits;

  /** Creates a finder for the tool of a verifier. */
  BlockingVoxels(BodyScene scene, RigidTool tool, MoverVerifier verifier) {
    this.scene = scene;
    this.tool = tool;
    this.verifier = verifier;
    tree = tool.tree();
    reachMm = REACH_EDGES * scene.shortestEdgeMm();
  }

  /**
   * Reports the solid voxels that block the tool, in the order in which the tool meets them. Voxels
   * of one cell come in the order of their indices, and a voxel may come twice. The sink may remove
   * a voxel that it takes.
   *
   * @param device the device pose, finite, with a quaternion of norm 1
   * @param sink receives the voxels until it wants no more
   */
  public void find(Pose device, Sink sink) {
    count = 0;
    hits = 0;
    setNext(device);
    for (int n = 0; n < scene.count(); n++) {
      findIn(n);
    }
    boolean isWanted = true;
    while (count > 0 && isWanted) {
      int cell = extreme(false);
      isWanted = report(cell, sink);
      copy(--count, cell);
    }
  }

  /**
   * {@return whether the tool at its present pose would touch a voxel, or enclose it, if it were
   * solid} A tool that would come nearer to it than its clearance counts too.
   *
   * @param index the body of the voxel
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean meets(int index, int i, int j, int k) {
    BodyVerifier ofBody = verifier.pair(index);
    if (ofBody.enclosure().encloses(i, j, k)) {
      return true;
    }
    int node = 0;
    while (node < tree.nodes()) {
      if (isFar(node, ofBody, i, j, k)) {
        node = tree.skip(node);
        continue;
      }
      for (int point = tree.first(node); tree.isLeaf(node) && point < tree.end(node); point++) {
        if (meets(ofBody, point, i, j, k)) {
          return true;
        }
      }
      node++;
    }
    return false;
  }

  /** Whether no point of a node lies within the growth of a voxel and the diagonal of a cell. */
  private boolean isFar(int node, BodyVerifier ofBody, int i, int j, int k) {
    ClearanceLevels levels = ofBody.levels;
    AffineMap map = ofBody.from();
    Vec3 s = levels.body.grid().spacingMm();
    double x = gap(map.x(tree.x(node), tree.y(node), tree.z(node)), i, s.x);
    double y = gap(map.y(tree.x(node), tree.y(node), tree.z(node)), j, s.y);
    double z = gap(map.z(tree.x(node), tree.y(node), tree.z(node)), k, s.z);
    double diagonalMm = s.length();
    double nearMm = FAR_FACTOR * (tree.radius(node) + levels.growthMm()) + diagonalMm;
    return x * x + y * y + z * z > nearMm * nearMm;
  }

  private static double gap(double coordinate, int voxel, double spacingMm) {
    return spacingMm * Math.max(0, Math.max(voxel - coordinate, coordinate - (voxel + 1)));
  }

  private boolean meets(BodyVerifier ofBody, int point, int i, int j, int k) {
    ClearanceLevels levels = ofBody.levels;
    int at = ofBody.level(point);
    levels.toCells(ofBody.from(), at, from);
    double x = from.x(tool.x(point), tool.y(point), tool.z(point));
    double y = from.y(tool.x(point), tool.y(point), tool.z(point));
    double z = from.z(tool.x(point), tool.y(point), tool.z(point));
    for (int c = (int) Math.ceil(z) - 1; c <= Math.floor(z); c++) {
      for (int b = (int) Math.ceil(y) - 1; b <= Math.floor(y); b++) {
        for (int a = (int) Math.ceil(x) - 1; a <= Math.floor(x); a++) {
          boolean reaches =
              at == 0 ? a == i && b == j && c == k : levels.grown(at).reaches(i, j, k, a, b, c);
          if (reaches) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Sets the pose to which the legs lead. */
  private void setNext(Pose device) {
    Pose pose = verifier.pose();
    pose.differenceTo(device, displacement, rotation, scratch);
    double mostMm = displacement.length() + rotation.length() * tool.radiusMm();
    double fraction = mostMm > reachMm ? reachMm / mostMm : 1;
    pose.displace(displacement, rotation, fraction, scratch, next);
  }

  private void findIn(int index) {
    BodyVerifier ofBody = verifier.pair(index);
    ClearanceLevels levels = ofBody.levels;
    levels.body.toolToGrid(next, toGrid);
    levels.toCells(ofBody.from(), levels.highest, from);
    levels.toCells(toGrid, levels.highest, to);
    int node = 0;
    while (node < tree.nodes()) {
      boolean isLeaf = tree.isLeaf(node);
      if (isEmptyAround(node, levels)) {
        node = tree.skip(node);
        continue;
      }
      for (int point = tree.first(node); isLeaf && point < tree.end(node); point++) {
        castFrom(index, ofBody, point);
      }
      node++;
    }
  }

  /**
   * Whether no solid cell lies within twice the longest motion of a point around a node. Rounding
   * is far below a motion.
   */
  private boolean isEmptyAround(int node, ClearanceLevels levels) {
    double x = from.x(tree.x(node), tree.y(node), tree.z(node));
    double y = from.y(tree.x(node), tree.y(node), tree.z(node));
    double z = from.z(tree.x(node), tree.y(node), tree.z(node));
    double neededMm = tree.radius(node) + 2 * reachMm;
    return levels.clearance.at(x, y, z) * levels.cellMm > neededMm;
  }

  private void castFrom(int index, BodyVerifier ofBody, int point) {
    ClearanceLevels levels = ofBody.levels;
    int at = ofBody.level(point);
    if (at != levels.highest) {
      levels.toCells(ofBody.from(), at, from);
      levels.toCells(toGrid, at, to);
    }
    cast(index, levels.cubes[at], at, point);
    if (at != levels.highest) {
      levels.toCells(ofBody.from(), levels.highest, from);
      levels.toCells(toGrid, levels.highest, to);
    }
  }

  private void cast(int index, BitCube cells, int at, int point) {
    double a = tool.x(point);
    double b = tool.y(point);
    double c = tool.z(point);
    leg.from(from.x(a, b, c), from.y(a, b, c), from.z(a, b, c));
    leg.to(to.x(a, b, c), to.y(a, b, c), to.z(a, b, c));
    boolean isFree =
        EmptyBox.holds(cells, leg.fromX, leg.fromY, leg.fromZ, leg.toX, leg.toY, leg.toZ);
    if (!isFree && caster.cast(cells, leg, hit)) {
      insert(index, at);
    }
  }

  /** Keeps the hit, unless there are enough that the tool meets no later. */
  private void insert(int index, int at) {
    int number = hits++;
    int place = number < MOST_CELLS ? count++ : extreme(true);
    if (number >= MOST_CELLS && t[place] <= hit.t) {
      return;
    }
    t[place] = hit.t;
    found[place] = number;
    body[place] = index;
    level[place] = at;
    cellX[place] = hit.i;
    cellY[place] = hit.j;
    cellZ[place] = hit.k;
  }

  /** Returns the cell that the tool meets first or last; of equals the first or last found. */
  private int extreme(boolean last) {
    int best = 0;
    for (int n = 1; n < count; n++) {
      boolean isBefore = t[n] < t[best] || (t[n] == t[best] && found[n] < found[best]);
      if (isBefore != last) {
        best = n;
      }
    }
    return best;
  }

  private void copy(int source, int dest) {
    t[dest] = t[source];
    found[dest] = found[source];
    body[dest] = body[source];
    level[dest] = level[source];
    cellX[dest] = cellX[source];
    cellY[dest] = cellY[source];
    cellZ[dest] = cellZ[source];
  }

  /** Reports the solid voxels that make a cell solid. Returns whether more are wanted. */
  private boolean report(int cell, Sink sink) {
    int a = cellX[cell];
    int b = cellY[cell];
    int c = cellZ[cell];
    if (level[cell] == 0) {
      return sink.take(body[cell], a, b, c);
    }
    BitCube bits = scene.body(body[cell]).bits();
    GrownSolids grown = verifier.pair(body[cell]).levels.grown(level[cell]);
    for (int k = grown.lowestVoxel(c, 2); k <= grown.highestVoxel(c, 2); k++) {
      for (int j = grown.lowestVoxel(b, 1); j <= grown.highestVoxel(b, 1); j++) {
        for (int i = grown.lowestVoxel(a, 0); i <= grown.highestVoxel(a, 0); i++) {
          boolean blocks = bits.get(i, j, k) && grown.reaches(i, j, k, a, b, c);
          if (blocks && !sink.take(body[cell], i, j, k)) {
            return false;
          }
        }
      }
    }
    return true;
  }
}
