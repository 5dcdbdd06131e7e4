package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.palpate.fracture.FaceLine;
import org.palpate.fracture.PartialVoxels;
import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * The surfaces of all fragments, each found when it is first needed. Each fragment has a grid of
 * its own, or all share one. One thread.
 */
final class FragmentSurfaces {
  /** The longest distance between faces that face each other, mm. */
  static final double REACH_MM = 4;

  /** The depth under a face of the occupancy that counts as full, voxel edges. */
  private static final double DEEP_EDGES = 1.5;

  private static final double WALK_EDGES = 0.5;

  /** The least cosine between a point's normal and the mean of its face. */
  private static final double FACE_COSINE = 0.5;

  private final List<VoxelGrid> grids;
  private final List<BitCube> fragments;
  private final List<Optional<PartialVoxels>> partial;
  private final FragmentSurface[] found;
  private final double edgeMm;

  /**
   * Prepares surfaces.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   */
  FragmentSurfaces(List<VoxelGrid> grids, List<BitCube> fragments) {
    this(grids, fragments, Collections.nCopies(fragments.size(), Optional.empty()));
  }

  /**
   * Prepares surfaces that lie where partly full voxels place them.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   * @param partial how full the voxels at the surface of each fragment are; if empty, only the bits
   *     count
   */
  FragmentSurfaces(
      List<VoxelGrid> grids, List<BitCube> fragments, List<Optional<PartialVoxels>> partial) {
    this.partial = List.copyOf(partial);
    this.grids = List.copyOf(grids);
    this.fragments = List.copyOf(fragments);
    found = new FragmentSurface[fragments.size()];
    edgeMm = grids.stream().mapToDouble(FragmentSurface::edgeMm).max().orElse(Double.NaN);
  }

  /** Returns the edge of a cube as large as a voxel, mm; of several grids, the longest one. */
  double edgeMm() {
    return edgeMm;
  }

  /** Returns searches of faces on lines across a fracture. */
  FaceLine faceLine() {
    return new FaceLine(edgeMm, DEEP_EDGES);
  }

  /** Returns the surface of a fragment at rest. */
  FragmentSurface of(int fragment) {
    if (found[fragment] == null) {
      found[fragment] =
          FragmentSurface.of(fragments.get(fragment), grids.get(fragment), partial.get(fragment));
    }
    return found[fragment];
  }

  /** Returns the smoothed occupancy of a fragment at its pose, from rest to present, world mm. */
  SmoothedBits smoothed(int fragment, List<Pose> poses) {
    return new SmoothedBits(
        new PosedBits(fragments.get(fragment), grids.get(fragment), poses.get(fragment)),
        partial.get(fragment),
        FragmentSurface.SIGMA);
  }

  /**
   * Returns the points of fragments that have another fragment in front of them.
   *
   * @param moves which fragments the points are on; the others are faced
   * @param poses the pose of each fragment, from rest to present, world mm
   */
  List<FacingPoint> facing(IntPredicate moves, List<Pose> poses) {
    List<FacingPoint> points = new ArrayList<>();
    for (int other = 0; other < poses.size(); other++) {
      if (!moves.test(other)) {
        SmoothedBits faced = smoothed(other, poses);
        for (int n = 0; n < poses.size(); n++) {
          if (moves.test(n)) {
            addFacing(n, other, faced, poses.get(n), points);
          }
        }
      }
    }
    return points;
  }

  /** Adds the points of one fragment whose normals are like the mean of those that face another. */
  private void addFacing(
      int fragment, int other, SmoothedBits faced, Pose pose, List<FacingPoint> points) {
    FragmentSurface surface = of(fragment);
    List<FacingPoint> near = new ArrayList<>();
    Vec3 sum = new Vec3();
    for (int n = 0; n < surface.points().size(); n++) {
      Vec3 point = pose.transform(surface.points().get(n), new Vec3());
      if (faced.isNear(point, REACH_MM + edgeMm)) {
        Vec3 normal = pose.rotation.rotate(surface.normals().get(n), new Vec3());
        if (hasInFront(faced, point, normal)) {
          near.add(new FacingPoint(fragment, other, n, point, normal));
          sum.add(normal, sum);
        }
      }
    }
    Vec3 across = mean(near, mean(near, sum));
    for (FacingPoint each : near) {
      if (each.direction().dot(across) >= FACE_COSINE) {
        points.add(new FacingPoint(fragment, other, each.index(), each.point(), across));
      }
    }
  }

  /** Returns the mean of the normals that are like a direction, a unit vector. */
  private static Vec3 mean(List<FacingPoint> points, Vec3 like) {
    Vec3 sum = new Vec3();
    for (FacingPoint each : points) {
      if (each.direction().dot(like) >= FACE_COSINE * like.length()) {
        sum.add(each.direction(), sum);
      }
    }
    double length = sum.length();
    return sum.mul(length > 0 ? 1 / length : 0, sum);
  }

  private boolean hasInFront(SmoothedBits faced, Vec3 point, Vec3 normal) {
    Vec3 probe = new Vec3();
    double step = WALK_EDGES * edgeMm;
    for (double t = -edgeMm; t <= REACH_MM + edgeMm; t += step) {
      probe.set(point.x + t * normal.x, point.y + t * normal.y, point.z + t * normal.z);
      if (faced.isSolid(probe)) {
        return true;
      }
    }
    return false;
  }

  /**
   * A point of a fragment's surface that faces another fragment.
   *
   * @param fragment the index of the fragment
   * @param other the index of the other
   * @param index the index of the point in the surface
   * @param point where it is, world mm
   * @param direction the mean normal of the face, towards the other
   */
  record FacingPoint(int fragment, int other, int index, Vec3 point, Vec3 direction) {}
}
