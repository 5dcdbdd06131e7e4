package org.palpate.rigid.tool;

import java.util.Arrays;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Voxelizes a closed mesh in one of two ways. For a tool, a voxel is solid if its centre lies in
 * the solid of the mesh or if the surface passes through the voxel. So the voxels contain the whole
 * solid, parts that are thinner than a voxel too. For a body, see {@link #voxelizeBody}.
 *
 * <p>The centre lies inside if the winding number of the mesh about it is not 0. It is counted
 * along rays parallel to z. {@link TriangleRay} decides in exact arithmetic which triangles a ray
 * meets, so no ray slips between two triangles and none counts one twice. One thread.
 */
public final class MeshVoxelizer {
  /** Pieces of the surface have edges of at most this, voxel edges. */
  private static final double PIECE_EDGES = 0.3;

  /** Boxes of pieces grow by this against the rounding of their corners, voxel edges. */
  private static final double ROUNDING_EDGES = 1e-9;

  private final TriangleMesh mesh;
  private final double edgeMm;
  private final Vec3 corner;
  private final BitCube bits;

  /** For each crossing: twice the index of the first voxel above it, plus 1 if it faces up. */
  private long[] crossings = new long[1024];

  private int count;
  private final Vec3 a = new Vec3();
  private final Vec3 b = new Vec3();
  private final Vec3 c = new Vec3();

  /**
   * Sets a grid of cubes up around the mesh.
   *
   * @param edgeMm the edge of a voxel, mm
   */
  MeshVoxelizer(TriangleMesh mesh, double edgeMm) {
    this(mesh, edgeMm, mesh.low());
  }

  private MeshVoxelizer(TriangleMesh mesh, double edgeMm, Vec3 low) {
    this.mesh = mesh;
    this.edgeMm = edgeMm;
    Vec3 size = mesh.high().sub(low, new Vec3());
    corner = low.sub(new Vec3(edgeMm, edgeMm, edgeMm), new Vec3());
    bits = new BitCube(voxels(size.x), voxels(size.y), voxels(size.z));
  }

  /**
   * {@return a voxelizer whose voxels have their corners at multiples of their edge} Meshes with
   * disjoint solids then share no voxel by its centre.
   *
   * @param mesh the mesh, in the frame of the voxels, mm
   * @param edgeMm the edge of a voxel, mm
   * @throws IllegalArgumentException if the mesh is not closed
   */
  public static MeshVoxelizer onMultiples(TriangleMesh mesh, double edgeMm) {
    if (!mesh.isClosed()) {
      throw new IllegalArgumentException("the mesh is not closed");
    }
    Vec3 low = mesh.low();
    low.set(
        Math.floor(low.x / edgeMm) * edgeMm,
        Math.floor(low.y / edgeMm) * edgeMm,
        Math.floor(low.z / edgeMm) * edgeMm);
    return new MeshVoxelizer(mesh, edgeMm, low);
  }

  private int voxels(double lengthMm) {
    return (int) Math.ceil(lengthMm / edgeMm) + 2;
  }

  /** Returns the voxels that contain the solid of the mesh. */
  VoxelSolid voxelize() {
    fillInside();
    fillSurface();
    return solid();
  }

  /**
   * {@return the voxels of a body: those whose centres lie in the solid of the mesh} Where a part
   * is too thin for that, it also takes the voxels that the surface passes through, so that no part
   * is lost. No point of the solid lies farther than the diagonal of a voxel from these voxels.
   */
  public VoxelSolid voxelizeBody() {
    fillInside();
    BitCube inside = bits.copy();
    fillSurface();
    VoxelSolid solid = solid();
    solid.forEachSolid(
        (i, j, k) -> {
          if (!inside.get(i, j, k) && hasNear(inside, i, j, k)) {
            bits.clear(i, j, k);
          }
        });
    return solid;
  }

  /** Whether one of the 26 voxels around a voxel is solid. */
  private static boolean hasNear(BitCube solid, int i, int j, int k) {
    for (int n = 0; n < 27; n++) {
      if (solid.get(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)) {
        return true;
      }
    }
    return false;
  }

  /** Fills the voxels that the surface passes through. */
  private void fillSurface() {
    PiecewiseSurface pieces = new PiecewiseSurface(PIECE_EDGES * edgeMm);
    for (int n = 0; n < mesh.triangleCount(); n++) {
      pieces.cut(mesh.corner(n, 0, a), mesh.corner(n, 1, b), mesh.corner(n, 2, c), this::fillPiece);
    }
  }

  private VoxelSolid solid() {
    RigidTransform gridMmToWorld =
        new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), corner);
    Vec3 spacing = new Vec3(edgeMm, edgeMm, edgeMm);
    return new VoxelSolid(
        bits, new VoxelGrid(bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, gridMmToWorld));
  }

  /** Fills the voxels whose centres lie in the solid of the mesh. */
  void fillInside() {
    TriangleRay ray = new TriangleRay();
    for (int n = 0; n < mesh.triangleCount(); n++) {
      ray.set(mesh.corner(n, 0, a), mesh.corner(n, 1, b), mesh.corner(n, 2, c));
      addCrossings(ray);
    }
    Arrays.sort(crossings, 0, count);
    int turn = 0;
    for (int n = 0; n < count; n++) {
      turn += (crossings[n] & 1) == 0 ? -1 : 1;
      if (turn != 0 && n + 1 < count) {
        fill(crossings[n] >> 1, crossings[n + 1] >> 1);
      }
    }
  }

  /** Adds the crossings of one triangle with the rays through the centres of columns of voxels. */
  private void addCrossings(TriangleRay ray) {
    int highI = index(ray.highX(), corner.x, bits.sizeX());
    int highJ = index(ray.highY(), corner.y, bits.sizeY());
    for (int j = index(ray.lowY(), corner.y, bits.sizeY()); j <= highJ; j++) {
      for (int i = index(ray.lowX(), corner.x, bits.sizeX()); i <= highI; i++) {
        int sign = ray.crossing(centre(i, corner.x), centre(j, corner.y));
        if (sign != 0) {
          long column = (long) j * bits.sizeX() + i;
          long voxel = column * (bits.sizeZ() + 1L) + firstAbove(ray, i, j);
          add((voxel << 1) | (sign > 0 ? 1 : 0));
        }
      }
    }
  }

  private void add(long crossing) {
    if (count == crossings.length) {
      crossings = Arrays.copyOf(crossings, 2 * count);
    }
    crossings[count++] = crossing;
  }

  /**
   * Fills the voxels from one index up to another. Both lie in one column, because the winding
   * number is 0 at the end of each.
   */
  private void fill(long from, long to) {
    long column = from / (bits.sizeZ() + 1L);
    int i = (int) (column % bits.sizeX());
    int j = (int) (column / bits.sizeX());
    int high = (int) Math.min(bits.sizeZ(), to - column * (bits.sizeZ() + 1L));
    for (int k = (int) (from % (bits.sizeZ() + 1L)); k < high; k++) {
      bits.set(i, j, k);
    }
  }

  /** Returns the first voxel of a column whose centre lies above the triangle. */
  private int firstAbove(TriangleRay ray, int i, int j) {
    double x = centre(i, corner.x);
    double y = centre(j, corner.y);
    int k = Math.min(bits.sizeZ(), index(ray.height(x, y), corner.z, bits.sizeZ()));
    while (k > 0 && ray.isBelow(x, y, centre(k - 1, corner.z))) {
      k--;
    }
    while (k < bits.sizeZ() && !ray.isBelow(x, y, centre(k, corner.z))) {
      k++;
    }
    return k;
  }

  /** Returns the voxel that holds a coordinate, cut to the grid. */
  private int index(double mm, double originMm, int size) {
    return (int) Math.max(0, Math.min(size - 1.0, Math.floor((mm - originMm) / edgeMm)));
  }

  private double centre(int index, double originMm) {
    return originMm + (index + 0.5) * edgeMm;
  }

  /** Makes the voxels that meet the box of a piece of the surface solid. */
  private void fillPiece(Vec3 p, Vec3 q, Vec3 r) {
    int highK = high(p.z, q.z, r.z, corner.z, bits.sizeZ());
    int highJ = high(p.y, q.y, r.y, corner.y, bits.sizeY());
    int highI = high(p.x, q.x, r.x, corner.x, bits.sizeX());
    for (int k = low(p.z, q.z, r.z, corner.z, bits.sizeZ()); k <= highK; k++) {
      for (int j = low(p.y, q.y, r.y, corner.y, bits.sizeY()); j <= highJ; j++) {
        for (int i = low(p.x, q.x, r.x, corner.x, bits.sizeX()); i <= highI; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  private int low(double p, double q, double r, double originMm, int size) {
    return index(Math.min(p, Math.min(q, r)) - ROUNDING_EDGES * edgeMm, originMm, size);
  }

  private int high(double p, double q, double r, double originMm, int size) {
    return index(Math.max(p, Math.max(q, r)) + ROUNDING_EDGES * edgeMm, originMm, size);
  }

  /** Returns the voxels that were filled so far. */
  BitCube bits() {
    return bits;
  }
}
