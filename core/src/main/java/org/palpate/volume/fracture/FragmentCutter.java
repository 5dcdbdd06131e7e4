package org.palpate.volume.fracture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.VoxelGrid;

/**
 * Cuts a bone into fragments of similar size. The fracture surfaces are those of a Voronoi diagram
 * of the bone that smooth random waves deform.
 *
 * <p>Only the largest component of the bone is cut. Each fragment is one component of voxels that
 * share faces, edges or corners. A piece that the surfaces separate from its fragment goes to the
 * fragment that it has most neighbours in. With a saw kerf of n voxels, at least n voxels along
 * some axis lie between any two fragments. Pieces that the saw cuts off are left out.
 *
 * <p>Reference: Voronoi fragments with sites spread by Lloyd's algorithm, 1982. One thread an
 * instance. Needs a byte for each voxel of the bone's box.
 */
public final class FragmentCutter {
  /** The smallest fragment, voxels. */
  public static final int LEAST_VOXELS = 64;

  private static final int LLOYD_STEPS = 4;

  /** Numbers that relate a wave's length and height to the diagonal of the bone's box. */
  private static final double SHORTEST_WAVE = 1.0 / 20;

  private static final double LONGEST_WAVE = 1.0 / 6;
  private static final double WAVE_RMS = 1.0 / 90;

  /** The shortest wave, longest voxel edges, because voxels cannot show a shorter one. */
  private static final double SHORTEST_WAVE_EDGES = 4;

  private final FractureSpec spec;
  private final BitCube bone;
  private final VoxelGrid grid;
  private final Uniform random;
  private final int[] voxels;
  private final LabelBox labels;

  private FragmentCutter(BitCube bone, VoxelGrid grid, FractureSpec spec) {
    this.bone = bone;
    this.grid = grid;
    this.spec = spec;
    random = new Uniform(spec.seed());
    voxels = new int[Math.toIntExact(3 * bone.solidCount())];
    IntBox box = new IntBox();
    ConnectedComponents.visit(
        bone,
        Neighbours.FACES_EDGES_CORNERS,
        (found, count) -> System.arraycopy(found, 0, voxels, 0, 3 * count));
    for (int n = 0; n < voxels.length; n += 3) {
      box.include(voxels[n], voxels[n + 1], voxels[n + 2]);
    }
    labels = new LabelBox(box);
  }

  /**
   * Cuts a bone into fragments.
   *
   * @param bone the voxels; not changed
   * @param grid their grid
   * @param spec the number of parts, the seed and the kerf
   * @return the fragments where they rest, the largest first
   * @throws IllegalArgumentException if a fragment would have fewer than {@link #LEAST_VOXELS}
   */
  public static Fragments cut(BitCube bone, VoxelGrid grid, FractureSpec spec) {
    BitCube largest = ConnectedComponents.largest(bone, Neighbours.FACES_EDGES_CORNERS);
    if (largest.solidCount() < (long) LEAST_VOXELS * spec.parts()) {
      throw tooSmall(largest.solidCount(), spec);
    }
    return new FragmentCutter(largest, grid, spec).cut(bone.solidCount());
  }

  private static IllegalArgumentException tooSmall(long voxels, FractureSpec spec) {
    return new IllegalArgumentException(
        "the bone is too small for so many fragments: "
            + voxels
            + " voxels in one piece, "
            + spec.parts()
            + " fragments: choose fewer fragments, a narrower kerf or another segment");
  }

  private Fragments cut(long boneVoxels) {
    assign(sites());
    mergeStrayPieces();
    for (int kerf = 1; kerf <= spec.kerfVoxels(); kerf++) {
      saw(kerf);
    }
    BitCube chips = emptyCube();
    List<BitCube> parts = new ArrayList<>();
    long kept = 0;
    for (int label = 1; label <= spec.parts(); label++) {
      labels.keepLargest(label, chips);
      BitCube part = labels.bits(label, bone);
      if (part.solidCount() < LEAST_VOXELS) {
        throw tooSmall(bone.solidCount(), spec);
      }
      kept += part.solidCount();
      parts.add(part);
    }
    parts.sort(Comparator.comparingLong(BitCube::solidCount).reversed());
    return new Fragments(grid, parts, boneVoxels - kept);
  }

  private BitCube emptyCube() {
    return new BitCube(bone.sizeX(), bone.sizeY(), bone.sizeZ());
  }

  /** Writes the centre of a voxel, grid mm, without the deformation. */
  private Vec3 centre(int n, Vec3 dest) {
    Vec3 spacing = grid.spacingMm();
    return dest.set(
        (voxels[n] + 0.5) * spacing.x,
        (voxels[n + 1] + 0.5) * spacing.y,
        (voxels[n + 2] + 0.5) * spacing.z);
  }

  /** Returns points spread over the bone, each in the middle of a part of it, grid mm. */
  private Vec3[] sites() {
    Vec3[] sites = spreadSites();
    for (int step = 0; step < LLOYD_STEPS; step++) {
      moveToMiddles(sites);
    }
    return sites;
  }

  /** Returns voxels that lie far from each other, with some randomness. */
  private Vec3[] spreadSites() {
    int count = voxels.length / 3;
    double[] squaredDistances = new double[count];
    Arrays.fill(squaredDistances, Double.MAX_VALUE);
    Vec3[] sites = new Vec3[spec.parts()];
    Vec3 centre = new Vec3();
    int picked = random.nextInt(count);
    for (int s = 0; s < sites.length; s++) {
      sites[s] = centre(3 * picked, new Vec3());
      double best = -1;
      for (int v = 0; v < count; v++) {
        centre(3 * v, centre).sub(sites[s], centre);
        squaredDistances[v] = Math.min(squaredDistances[v], centre.dot(centre));
        double score = squaredDistances[v] * random.next(0.6, 1);
        if (score > best) {
          best = score;
          picked = v;
        }
      }
    }
    return sites;
  }

  private void moveToMiddles(Vec3[] sites) {
    Vec3[] sums = new Vec3[sites.length];
    long[] counts = new long[sites.length];
    for (int s = 0; s < sites.length; s++) {
      sums[s] = new Vec3();
    }
    Vec3 centre = new Vec3();
    for (int n = 0; n < voxels.length; n += 3) {
      int nearest = nearest(sites, centre(n, centre));
      sums[nearest].add(centre, sums[nearest]);
      counts[nearest]++;
    }
    for (int s = 0; s < sites.length; s++) {
      sums[s].mul(1.0 / Math.max(1, counts[s]), sites[s]);
    }
  }

  private static int nearest(Vec3[] sites, Vec3 position) {
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int s = 0; s < sites.length; s++) {
      double dx = sites[s].x - position.x;
      double dy = sites[s].y - position.y;
      double dz = sites[s].z - position.z;
      double squared = dx * dx + dy * dy + dz * dz;
      if (squared < least) {
        least = squared;
        nearest = s;
      }
    }
    return nearest;
  }

  /** Gives each voxel the label of the site that is nearest to its displaced position. */
  private void assign(Vec3[] sites) {
    Waves waves = waves();
    Vec3 position = new Vec3();
    for (int n = 0; n < voxels.length; n += 3) {
      waves.displace(centre(n, position));
      labels.set(voxels[n], voxels[n + 1], voxels[n + 2], 1 + nearest(sites, position));
    }
  }

  private Waves waves() {
    Vec3 spacing = grid.spacingMm();
    double diagonal = grid.diagonalMm(bone.bounds());
    double longestEdge = Math.max(spacing.x, Math.max(spacing.y, spacing.z));
    double shortest = Math.max(SHORTEST_WAVE * diagonal, SHORTEST_WAVE_EDGES * longestEdge);
    return new Waves(
        random, WAVE_RMS * diagonal, shortest, Math.max(2 * shortest, LONGEST_WAVE * diagonal));
  }

  /** Gives each piece that lies apart from its fragment to the fragment that it touches most. */
  private void mergeStrayPieces() {
    BitCube strays = emptyCube();
    for (int label = 1; label <= spec.parts(); label++) {
      labels.keepLargest(label, strays);
    }
    ConnectedComponents.visit(strays, Neighbours.FACES_EDGES_CORNERS, this::merge);
  }

  private void merge(int[] piece, int count) {
    int[] neighbours = new int[spec.parts() + 1];
    for (int n = 0; n < 3 * count; n += 3) {
      labels.countNeighbours(piece[n], piece[n + 1], piece[n + 2], neighbours);
    }
    int most = 1;
    for (int label = 2; label <= spec.parts(); label++) {
      most = neighbours[label] > neighbours[most] ? label : most;
    }
    for (int n = 0; n < 3 * count; n += 3) {
      labels.set(piece[n], piece[n + 1], piece[n + 2], most);
    }
  }

  /**
   * Widens the cut between all fragments by a voxel: from one fragment of each pair it takes the
   * voxels that lie within {@code kerf} voxels of the other, from the two in turn.
   */
  private void saw(int kerf) {
    LabelBox before = labels.copy();
    for (int n = 0; n < voxels.length; n += 3) {
      int i = voxels[n];
      int j = voxels[n + 1];
      int k = voxels[n + 2];
      int label = before.get(i, j, k);
      int least = kerf % 2 == 1 ? 1 : label + 1;
      int most = kerf % 2 == 1 ? label - 1 : spec.parts();
      if (label != 0 && before.hasNear(i, j, k, kerf, least, most)) {
        labels.set(i, j, k, 0);
      }
    }
  }
}
