package org.palpate.volume.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Voxels on a grid, and a pose.
 *
 * @param bits the voxels
 * @param grid their grid, at rest
 * @param pose the pose, from rest to present, world mm
 */
public record PosedBits(BitCube bits, VoxelGrid grid, Pose pose) {
  /** The most voxels of a grid around bodies, unless the grid that it extends has more. */
  private static final double MOST_VOXELS = 1 << 26;

  /**
   * {@return the segments of a volume at poses, each on its own grid}
   *
   * @param rest the segments where they rest
   * @param poses the pose of each segment, from rest to present, world mm
   */
  public static List<PosedBits> of(SegmentedVolume rest, List<Pose> poses) {
    List<PosedBits> bodies = new ArrayList<>();
    for (int n = 0; n < poses.size(); n++) {
      bodies.add(new PosedBits(rest.segments().get(n).bits(), rest.grid(n), poses.get(n)));
    }
    return bodies;
  }

  /**
   * {@return the segments of a volume at poses, all on one grid; see {@link #resample(List,
   * VoxelGrid)}}
   *
   * @param rest the segments where they rest
   * @param poses the pose of each segment, from rest to present, world mm
   * @param target the grid of the result
   */
  public static SegmentedVolume resample(SegmentedVolume rest, List<Pose> poses, VoxelGrid target) {
    List<BitCube> cubes = resample(of(rest, poses), target);
    List<Segment> segments = new ArrayList<>();
    for (Segment segment : rest.segments()) {
      segments.add(new Segment(segment.name(), cubes.get(segments.size()), segment.rgb()));
    }
    return new SegmentedVolume(target, segments);
  }

  /**
   * {@return a grid that holds the centres of all voxels of the bodies} It is the given one if that
   * does. Otherwise it has the same axes and more voxels, which are larger if there were too many.
   *
   * @param bodies the bodies whose voxels it has to hold
   * @param like the grid to return if it holds them, else the one whose axes to take
   */
  public static VoxelGrid gridAround(List<PosedBits> bodies, VoxelGrid like) {
    if (bodies.stream().allMatch(body -> body.voxelsOutside(like) == 0)) {
      return like;
    }
    Vec3 low = new Vec3();
    Vec3 high = new Vec3(like.sizeX(), like.sizeY(), like.sizeZ());
    bodies.forEach(body -> body.include(like, low, high));
    low.set(Math.floor(low.x), Math.floor(low.y), Math.floor(low.z));
    Vec3 size = high.sub(low, new Vec3());
    double scale = 1;
    while (voxels(size, scale) > Math.max(MOST_VOXELS, (double) like.voxelCount())) {
      scale *= 2;
    }
    RigidTransform axes = like.gridMmToWorld();
    return new VoxelGrid(
        (int) Math.ceil(size.x / scale),
        (int) Math.ceil(size.y / scale),
        (int) Math.ceil(size.z / scale),
        like.spacingMm().mul(scale, new Vec3()),
        new RigidTransform(
            axes.axisX(), axes.axisY(), axes.axisZ(), like.gridToWorld(low, new Vec3())));
  }

  private static double voxels(Vec3 size, double scale) {
    return Math.ceil(size.x / scale) * Math.ceil(size.y / scale) * Math.ceil(size.z / scale);
  }

  /**
   * {@return the number of voxels whose centres lie outside a grid}
   *
   * @param target the grid, at rest in the world
   */
  public long voxelsOutside(VoxelGrid target) {
    AffineMap toTarget = new PosedBits(bits, target, new Pose()).gridFrom(grid, pose);
    IntBox box = bits.bounds();
    Vec3 p = new Vec3();
    long outside = 0;
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          toTarget.transform(p.set(i + 0.5, j + 0.5, k + 0.5), p);
          if (bits.get(i, j, k) && !isInside(p, target)) {
            outside++;
          }
        }
      }
    }
    return outside;
  }

  private static boolean isInside(Vec3 p, VoxelGrid target) {
    return p.x >= 0
        && p.x < target.sizeX()
        && p.y >= 0
        && p.y < target.sizeY()
        && p.z >= 0
        && p.z < target.sizeZ();
  }

  /**
   * Returns the voxels of a grid whose centres lie in voxels of the posed bodies. This is
   * nearest-voxel resampling by the inverse map. It leaves no gap inside a body, nor between bodies
   * that touch as they did at rest. A voxel that lies in two bodies goes to the one whose voxel
   * centre is nearer. If both are equally near, it goes to the first one.
   *
   * @param bodies the bodies at their poses; an earlier one has precedence, as stated
   * @param target the grid to sample on, at rest in the world
   * @return a cube for each body, of the size of the grid; no two share a voxel
   */
  public static List<BitCube> resample(List<PosedBits> bodies, VoxelGrid target) {
    List<BitCube> cubes = new ArrayList<>();
    List<AffineMap> maps = new ArrayList<>();
    for (PosedBits body : bodies) {
      cubes.add(new BitCube(target.sizeX(), target.sizeY(), target.sizeZ()));
      maps.add(body.gridFrom(target, new Pose()));
    }
    Resampling work = new Resampling(bodies, cubes, maps);
    for (int n = 0; n < bodies.size(); n++) {
      work.fill(n, bodies.get(n).boxIn(target));
    }
    return cubes;
  }

  /**
   * {@return the map from the coordinates of another posed grid to the grid of this posed body}
   *
   * @param other the other grid
   * @param otherPose from the rest of the other grid to its present place, world mm
   */
  public AffineMap gridFrom(VoxelGrid other, Pose otherPose) {
    AffineMap otherToRest = other.gridToWorld(new AffineMap());
    AffineMap otherToWorld = new AffineMap().set(otherPose).multiply(otherToRest, new AffineMap());
    AffineMap worldToRest = new AffineMap().setInverse(pose);
    AffineMap restToGrid = grid.worldToGrid(new AffineMap());
    AffineMap worldToGrid = restToGrid.multiply(worldToRest, new AffineMap());
    return worldToGrid.multiply(otherToWorld, new AffineMap());
  }

  /** Returns the box of the voxels of a grid that may lie in this body; empty if none does. */
  private IntBox boxIn(VoxelGrid target) {
    IntBox box = new IntBox();
    IntBox solid = bits.bounds();
    if (solid.isEmpty()) {
      return box;
    }
    Vec3 low = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
    Vec3 high = new Vec3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);
    include(target, low, high);
    box.lowX = clamped(low.x - 1, target.sizeX());
    box.lowY = clamped(low.y - 1, target.sizeY());
    box.lowZ = clamped(low.z - 1, target.sizeZ());
    box.highX = clamped(high.x + 1, target.sizeX());
    box.highY = clamped(high.y + 1, target.sizeY());
    box.highZ = clamped(high.z + 1, target.sizeZ());
    return box;
  }

  /** Extends a box in coordinates of a grid so that it holds the voxels of this body. */
  private void include(VoxelGrid target, Vec3 low, Vec3 high) {
    IntBox solid = bits.bounds();
    Vec3 p = new Vec3();
    for (int corner = 0; corner < 8 && !solid.isEmpty(); corner++) {
      p.set(
          (corner & 1) == 0 ? solid.lowX : solid.highX + 1.0,
          (corner & 2) == 0 ? solid.lowY : solid.highY + 1.0,
          (corner & 4) == 0 ? solid.lowZ : solid.highZ + 1.0);
      target.worldToGrid(pose.transform(grid.gridToWorld(p, p), p), p);
      for (int axis = 0; axis < 3; axis++) {
        low.set(axis, Math.min(low.get(axis), p.get(axis)));
        high.set(axis, Math.max(high.get(axis), p.get(axis)));
      }
    }
  }

  private static int clamped(double coordinate, int size) {
    return (int) Math.max(0, Math.min(size - 1, Math.floor(coordinate)));
  }

  /** The state of a resampling. */
  private record Resampling(List<PosedBits> bodies, List<BitCube> cubes, List<AffineMap> maps) {
    void fill(int body, IntBox box) {
      Vec3 p = new Vec3();
      if (box.isEmpty()) {
        return;
      }
      for (int k = box.lowZ; k <= box.highZ; k++) {
        for (int j = box.lowY; j <= box.highY; j++) {
          for (int i = box.lowX; i <= box.highX; i++) {
            if (isSolidAt(body, i, j, k, p)) {
              claim(body, i, j, k, p);
            }
          }
        }
      }
    }

    private boolean isSolidAt(int body, int i, int j, int k, Vec3 scratch) {
      maps.get(body).transform(scratch.set(i + 0.5, j + 0.5, k + 0.5), scratch);
      return bodies
          .get(body)
          .bits()
          .get(
              (int) Math.floor(scratch.x),
              (int) Math.floor(scratch.y),
              (int) Math.floor(scratch.z));
    }

    private void claim(int body, int i, int j, int k, Vec3 scratch) {
      for (int earlier = 0; earlier < body; earlier++) {
        if (cubes.get(earlier).get(i, j, k)) {
          if (offCentreMm(earlier, i, j, k, scratch) <= offCentreMm(body, i, j, k, scratch)) {
            return;
          }
          cubes.get(earlier).clear(i, j, k);
        }
      }
      cubes.get(body).set(i, j, k);
    }

    /** Returns the distance of a target voxel's centre from the centre of the body's voxel, mm. */
    private double offCentreMm(int body, int i, int j, int k, Vec3 scratch) {
      maps.get(body).transform(scratch.set(i + 0.5, j + 0.5, k + 0.5), scratch);
      Vec3 spacing = bodies.get(body).grid().spacingMm();
      return scratch
          .set(
              (scratch.x - Math.floor(scratch.x) - 0.5) * spacing.x,
              (scratch.y - Math.floor(scratch.y) - 0.5) * spacing.y,
              (scratch.z - Math.floor(scratch.z) - 0.5) * spacing.z)
          .length();
    }
  }
}
