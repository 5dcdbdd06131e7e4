package org.palpate.volume.phantom;

import org.palpate.geometry.Vec3;

/** The analytic surfaces of the phantoms that have one. */
final class AnalyticSurfaces {
  private AnalyticSurfaces() {}

  /** A solid ball. */
  record Ball(Vec3 centre, double radius) implements AnalyticSurface {
    @Override
    public double signedDistance(Vec3 grid) {
      return grid.sub(centre, new Vec3()).length() - radius;
    }

    @Override
    public Vec3 normal(Vec3 grid, Vec3 dest) {
      grid.sub(centre, dest);
      return dest.mul(1 / dest.length(), dest);
    }
  }

  /** A spherical wall one voxel thick, whose outer side has the radius. */
  record Wall(Vec3 centre, double radius) implements AnalyticSurface {
    private static final double HALF_THICKNESS = 0.5;

    private double fromMiddle(Vec3 grid) {
      return grid.sub(centre, new Vec3()).length() - (radius - HALF_THICKNESS);
    }

    @Override
    public double signedDistance(Vec3 grid) {
      return Math.abs(fromMiddle(grid)) - HALF_THICKNESS;
    }

    @Override
    public Vec3 normal(Vec3 grid, Vec3 dest) {
      double side = fromMiddle(grid) < 0 ? -1 : 1;
      grid.sub(centre, dest);
      return dest.mul(side / dest.length(), dest);
    }
  }

  /** The half-space behind a plane. */
  record Plane(Vec3 point, Vec3 unitNormal) implements AnalyticSurface {
    @Override
    public double signedDistance(Vec3 grid) {
      return unitNormal.dot(grid) - unitNormal.dot(point);
    }

    @Override
    public Vec3 normal(Vec3 grid, Vec3 dest) {
      return dest.set(unitNormal);
    }
  }

  /** A solid torus around the z axis through the centre. */
  record Ring(Vec3 centre, double ringRadius, double tubeRadius) implements AnalyticSurface {
    @Override
    public double signedDistance(Vec3 grid) {
      return fromRing(grid, new Vec3()).length() - tubeRadius;
    }

    @Override
    public Vec3 normal(Vec3 grid, Vec3 dest) {
      fromRing(grid, dest);
      return dest.mul(1 / dest.length(), dest);
    }

    private Vec3 fromRing(Vec3 grid, Vec3 dest) {
      grid.sub(centre, dest);
      double fraction = 1 - ringRadius / Math.sqrt(dest.x * dest.x + dest.y * dest.y);
      return dest.set(dest.x * fraction, dest.y * fraction, dest.z);
    }
  }
}
