package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.scene.SceneLoader;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The segments that a view draws at present, where it draws them. Any thread reads them; the
 * synchronization thread moves them.
 */
final class DrawnSolids {
  private final SegmentedVolume rest;
  private volatile List<Segment> segments;
  private final List<RigidTransform> starts;
  private volatile List<RigidTransform> poses;
  private boolean hasGhosts;

  /**
   * Creates the segments of a volume.
   *
   * @param poses the pose of each segment, from rest to present, world mm; none if all are at rest
   */
  DrawnSolids(SegmentedVolume volume, List<RigidTransform> poses) {
    rest = volume;
    starts = List.copyOf(poses);
    this.poses = starts;
    segments = volume.segments();
  }

  /** Replaces the voxels of a segment. */
  synchronized void replace(int segment, BitCube bits) {
    List<Segment> changed = new ArrayList<>(segments);
    Segment old = changed.get(segment);
    changed.set(segment, new Segment(old.name(), bits, old.rgb()));
    segments = List.copyOf(changed);
  }

  /** Returns the pose of each segment, from rest to present, world mm; none if all are at rest. */
  List<RigidTransform> poses() {
    return poses;
  }

  /**
   * Moves the bodies that have moved since the last call.
   *
   * @param published the poses of the last publication that was taken
   * @param shown draws them; empty before there is a window
   */
  void follow(ToolPublisher published, Optional<SceneLoader> shown) {
    for (int n = 0; n < poses.size(); n++) {
      Optional<RigidTransform> pose = published.bodyPose(n);
      if (pose.isPresent() && !pose.get().sameBits(poses.get(n))) {
        List<RigidTransform> moved = new ArrayList<>(poses);
        moved.set(n, pose.get());
        poses = List.copyOf(moved);
        int segment = n;
        shown.ifPresent(loader -> loader.move(segment, pose.get()));
      }
    }
  }

  /**
   * Shows faint copies where the bodies started, or hides them.
   *
   * @param shown draws them; null while there is no window
   */
  synchronized void toggleGhosts(SceneLoader shown) {
    hasGhosts = !hasGhosts && shown != null;
    for (int n = 0; n < starts.size() && shown != null; n++) {
      shown.showGhost(n, hasGhosts ? Optional.of(starts.get(n)) : Optional.empty());
    }
  }

  /** Moves the surfaces of a loader to the present poses. */
  void showPoses(SceneLoader shown) {
    List<RigidTransform> present = poses;
    for (int n = 0; n < present.size(); n++) {
      shown.move(n, present.get(n));
    }
  }

  /**
   * Examines the drawn voxels around points and along rays. World mm. One thread. It reads voxels
   * without a lock, so one that changes meanwhile may count as it was.
   */
  static final class Probe {
    private final DrawnSolids solids;
    private final RayCaster caster = new ExactRayCaster();
    private final Ray ray = new Ray();
    private final RayHit hit = new RayHit();
    private final Vec3 from = new Vec3();
    private final Vec3 to = new Vec3();
    private List<Segment> segments = List.of();
    private List<RigidTransform> poses = List.of();

    /** Receives a solid voxel. */
    @FunctionalInterface
    interface VoxelSink {
      /** Receives its centre, world mm; a new vector. */
      void take(Vec3 centreMm);
    }

    Probe(DrawnSolids solids) {
      this.solids = solids;
    }

    /** Returns the longest voxel edge of all segments, mm. */
    double longestEdgeMm() {
      double longest = longestEdgeMm(solids.rest.grid());
      for (VoxelGrid own : solids.rest.grids()) {
        longest = Math.max(longest, longestEdgeMm(own));
      }
      return longest;
    }

    private static double longestEdgeMm(VoxelGrid grid) {
      Vec3 spacing = grid.spacingMm();
      return Math.max(spacing.x, Math.max(spacing.y, spacing.z));
    }

    /** Takes the segments as they are drawn now. */
    void refresh() {
      segments = solids.segments;
      poses = solids.poses;
    }

    /**
     * Returns where the ray between two points first meets a solid, as a fraction of its length.
     * Empty if it meets none or a point is not finite.
     */
    OptionalDouble firstHit(Vec3 fromMm, Vec3 toMm) {
      return first(fromMm, toMm) < 0 ? OptionalDouble.empty() : OptionalDouble.of(hit.t);
    }

    /**
     * Returns the name of the first segment that the ray between two points meets.
     *
     * @param fromGrid the start in coordinates of the volume's grid
     * @param toGrid the end, likewise
     */
    Optional<String> firstName(Vec3 fromGrid, Vec3 toGrid) {
      int first =
          first(
              solids.rest.grid().gridToWorld(fromGrid, new Vec3()),
              solids.rest.grid().gridToWorld(toGrid, new Vec3()));
      return first < 0 ? Optional.empty() : Optional.of(segments.get(first).name());
    }

    /** Returns the index of the first segment that a ray meets, and sets its hit; -1 if none. */
    private int first(Vec3 fromMm, Vec3 toMm) {
      int first = -1;
      double least = Double.POSITIVE_INFINITY;
      for (int n = 0; n < segments.size() && fromMm.isFinite() && toMm.isFinite(); n++) {
        toGrid(n, fromMm, from);
        toGrid(n, toMm, to);
        ray.from(from.x, from.y, from.z).to(to.x, to.y, to.z);
        if (caster.cast(segments.get(n).bits(), ray, hit) && hit.t < least) {
          least = hit.t;
          first = n;
        }
      }
      hit.t = least;
      return first;
    }

    /**
     * Reports the solid voxels around a point.
     *
     * @param reachMm how far they may lie from the point's voxel along an axis
     * @param most the most voxels on either side of the point's voxel
     */
    void around(Vec3 pointMm, double reachMm, int most, VoxelSink sink) {
      for (int n = 0; n < segments.size(); n++) {
        BitCube bits = segments.get(n).bits();
        Vec3 spacing = solids.rest.grid(n).spacingMm();
        int reachX = (int) Math.min(most, reachMm / spacing.x);
        int reachY = (int) Math.min(most, reachMm / spacing.y);
        int reachZ = (int) Math.min(most, reachMm / spacing.z);
        toGrid(n, pointMm, from);
        int i = (int) Math.floor(from.x);
        int j = (int) Math.floor(from.y);
        int k = (int) Math.floor(from.z);
        for (int z = k - reachZ; z <= k + reachZ; z++) {
          for (int y = j - reachY; y <= j + reachY; y++) {
            for (int x = i - reachX; x <= i + reachX; x++) {
              if (bits.get(x, y, z)) {
                sink.take(centreMm(n, x, y, z));
              }
            }
          }
        }
      }
    }

    private void toGrid(int segment, Vec3 mm, Vec3 dest) {
      Vec3 rest = poses.isEmpty() ? mm : poses.get(segment).inverseTransform(mm, dest);
      solids.rest.grid(segment).worldToGrid(rest, dest);
    }

    private Vec3 centreMm(int segment, int i, int j, int k) {
      Vec3 centre = new Vec3(i + 0.5, j + 0.5, k + 0.5);
      solids.rest.grid(segment).gridToWorld(centre, centre);
      return poses.isEmpty() ? centre : poses.get(segment).transform(centre, centre);
    }
  }
}
