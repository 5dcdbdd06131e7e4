package org.palpate.proxy.smooth;

import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.IsoLevel;
import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * Estimates the height of the isosurface above the solids at the interaction point. The force
 * subtracts this height from |p-d|. Uses the field as it was evaluated last. All results are in mm.
 */
final class SurfaceHeight {
  /** The path over which curvature is smoothed. */
  private static final double SMOOTHING_PATH_EDGES = 12;

  /**
   * The ripple of the voxels in a single curvature. The smoothed curvature differs from it by no
   * more.
   */
  private static final double RIPPLE_EDGES = 0.05;

  private final FieldSample sample;
  private final IsoLevel level;
  private final double shortestMm;
  private double curvatureShiftEdges;

  SurfaceHeight(OccupancyField field, EdgeUnits units) {
    sample = field.sample();
    level = field.level();
    shortestMm = units.shortestMm();
  }

  /**
   * Updates the estimate for a point that slides on the isosurface.
   *
   * @param pathMm the length of the frame's path
   */
  double onSurfaceMm(double pathMm) {
    return shortestMm * onSurfaceEdges(pathMm);
  }

  /**
   * Updates the estimate for a point that single voxels stop. It lies between the height on the
   * isosurface, if occupancy is high around the point, and 0, if it is low.
   *
   * @param pathMm the length of the frame's path
   */
  double onVoxelsMm(double pathMm) {
    if (!sample.hasNormal()) {
      return 0;
    }
    double crowding = 2 * sample.occupancy() / level.occupancy(sample.normal()) - 1;
    double height = Math.min(level.offsetEdges(sample.normal()), onSurfaceEdges(pathMm));
    return shortestMm * (Math.max(0, Math.min(1, crowding)) * height);
  }

  private double onSurfaceEdges(double pathMm) {
    double aboveIsosurface = sample.boundedHeightEdges(); // finds the normal too
    double offset = level.offsetEdges(sample.normal());
    double max = offset + FieldSample.MAX_HEIGHT_EDGES;
    double aboveFlatSolid = offset + aboveIsosurface;
    updateCurvatureShift(pathMm);
    return Math.max(0, Math.min(max, aboveFlatSolid - curvatureShiftEdges));
  }

  /**
   * Smooths over the path how much closer the isosurface runs to a curved surface, because single
   * curvatures carry the ripple of the voxels.
   */
  private void updateCurvatureShift(double pathMm) {
    double now = level.curvatureShiftEdges(sample.curvatureSum());
    double fraction = Math.min(1, pathMm / (shortestMm * SMOOTHING_PATH_EDGES));
    double smoothed = curvatureShiftEdges + fraction * (now - curvatureShiftEdges);
    curvatureShiftEdges = Math.max(now - RIPPLE_EDGES, Math.min(now + RIPPLE_EDGES, smoothed));
  }
}
