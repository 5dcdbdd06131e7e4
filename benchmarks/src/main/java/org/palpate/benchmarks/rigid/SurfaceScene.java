package org.palpate.benchmarks.rigid;

import java.util.List;
import org.palpate.benchmarks.accuracy.SampledSolids;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/**
 * A phantom as the only body of a scene. Its grid begins at the origin of the world, along the
 * world's axes.
 *
 * @param name the kind of phantom
 * @param edgeMm the edge of the cube that it fills, mm
 * @param bodies the scene
 * @param truth the surface that the voxels sample, world mm; null for the skull
 */
record SurfaceScene(String name, double edgeMm, BodyScene bodies, AnalyticSurface truth) {
  private static final String SKULL = "skull";

  /** Returns {@code plane}, {@code sphere} or {@code torus} at a spacing. */
  static SurfaceScene analytic(String kind, int edge, Vec3 spacingMm) {
    AnalyticSurface truth = Phantom.parse(kind + ":" + edge).analyticSurface().orElseThrow();
    BitCube bits = SampledSolids.of(truth, edge, spacingMm);
    VoxelGrid grid =
        new VoxelGrid(
            bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacingMm, RigidTransform.identity());
    return new SurfaceScene(kind, edge, scene(bits, grid), truth);
  }

  /** Returns {@code plane}, {@code sphere}, {@code torus} or {@code skull} of unit voxels. */
  static SurfaceScene of(String kind, int edge) {
    if (!kind.equals(SKULL)) {
      return analytic(kind, edge, new Vec3(1, 1, 1));
    }
    Segment skull =
        Phantom.parse("head:" + edge).segments().segments().stream()
            .filter(segment -> segment.name().equals(SKULL))
            .findFirst()
            .orElseThrow();
    return new SurfaceScene(SKULL, edge, scene(skull.bits()), null);
  }

  /** Returns a scene of unit voxels. */
  static BodyScene scene(BitCube bits) {
    return scene(bits, VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ()));
  }

  private static BodyScene scene(BitCube bits, VoxelGrid grid) {
    return new BodyScene(List.of(new Body("body", bits, grid, Mobility.FIXED)));
  }

  /**
   * Writes a point on the surface, or outside the skull, and the normal there.
   *
   * @param point written, world mm
   * @param normal written, unit
   */
  void landing(Vec3 point, Vec3 normal) {
    double out = 0.4 * edgeMm;
    if (name.equals("torus")) {
      point.set(0.33 * edgeMm, 0.05 * edgeMm, 0.3 * edgeMm);
    } else {
      point.set(0.231 * out, 0.377 * out, 0.894 * out);
    }
    normal.set(point).mul(1 / point.length(), normal);
    point.add(new Vec3(edgeMm / 2, edgeMm / 2, edgeMm / 2), point);
    if (truth != null) {
      truth.normal(point, normal);
      double height = truth.signedDistance(point);
      point.sub(normal.mul(height, new Vec3()), point);
    }
  }
}
