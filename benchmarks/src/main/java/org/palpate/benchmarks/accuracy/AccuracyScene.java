package org.palpate.benchmarks.accuracy;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/**
 * A phantom as bits and as grey values, with its analytic surface. Voxels have any edges; a grey
 * value is the mean over its voxel.
 */
final class AccuracyScene {
  /** The edge of the cube that the phantom fills, mm. */
  final int edge;

  final AnalyticSurface truth;
  final GridMetric metric;
  final BitCube bits;
  final CollisionScene collisionScene;

  /** The isosurface of the grey values. */
  final GreyIsosurface grey;

  /** The solids that a threshold makes from the grey values. */
  final CollisionScene greyCollisionScene;

  /**
   * Makes a phantom of a kind.
   *
   * @param edge the edge of the cube that it fills, mm
   * @param spacingMm the edges of a voxel
   */
  AccuracyScene(String kind, int edge, Vec3 spacingMm) {
    this.edge = edge;
    truth = Phantom.parse(kind + ":" + edge).analyticSurface().orElseThrow();
    metric = GridMetric.of(spacingMm);
    bits = SampledSolids.of(truth, edge, spacingMm);
    collisionScene = new CollisionScene(List.of(bits));
    ScalarVolume volume = SampledSolids.greyOf(truth, edge, spacingMm);
    grey = new GreyIsosurface(volume, Phantom.HALF_GREY, Phantom.HALF_GREY);
    greyCollisionScene = new CollisionScene(List.of(SampledSolids.threshold(volume)));
  }

  /** Writes a position in millimetres as grid coordinates. */
  Vec3 toGrid(Vec3 mm, Vec3 dest) {
    return dest.set(mm.x / metric.spacingX(), mm.y / metric.spacingY(), mm.z / metric.spacingZ());
  }

  /** Writes a vector in grid coordinates as millimetres. */
  Vec3 toMm(Vec3 grid, Vec3 dest) {
    return dest.set(
        grid.x * metric.spacingX(), grid.y * metric.spacingY(), grid.z * metric.spacingZ());
  }
}
