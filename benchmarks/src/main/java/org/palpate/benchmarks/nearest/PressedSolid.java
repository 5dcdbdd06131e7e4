package org.palpate.benchmarks.nearest;

import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * A solid inside a grid. A voxel is solid if its centre lies within the surface.
 *
 * @param shape the name in tables; several solids may share it
 * @param bits the solid voxels
 * @param truth the surface
 */
record PressedSolid(String shape, BitCube bits, AnalyticSurface truth) {
  static final int EDGE = 112;

  private static final Vec3 MIDDLE = new Vec3(56.3, 55.6, 56.1);

  /** Returns boxes along the axes, balls, cylinders and tilted planes. */
  static List<PressedSolid> all() {
    return List.of(
        of("box", box(new Vec3(12, 12, 12), new Vec3(100, 100, 100))),
        of("box", box(new Vec3(10, 15, 11), new Vec3(98, 95, 101))),
        of("ball", ball(40)),
        of("ball", ball(34.3)),
        of("cylinder", cylinder(new Vec3(0, 0, 1), 38.4)),
        of("cylinder", cylinder(new Vec3(1, 2, 3), 38.4)),
        of("cylinder", cylinder(new Vec3(0, -1, 4), 34)),
        of("tilted plane", plane(new Vec3(1, 1, 1))),
        of("tilted plane", plane(new Vec3(0, 1, 1))),
        of("tilted plane", plane(new Vec3(1, 2, 3))),
        of("tilted plane", plane(new Vec3(0.1, -0.2, 1))),
        of("tilted plane", plane(new Vec3(-3, 1, 1))));
  }

  private static PressedSolid of(String shape, AnalyticSurface truth) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    Vec3 centre = new Vec3();
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (truth.signedDistance(centre.set(i + 0.5, j + 0.5, k + 0.5)) <= 0) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return new PressedSolid(shape, bits, truth);
  }

  private static AnalyticSurface ball(double radius) {
    return new AnalyticSurface() {
      @Override
      public double signedDistance(Vec3 grid) {
        return grid.sub(MIDDLE, new Vec3()).length() - radius;
      }

      @Override
      public Vec3 normal(Vec3 grid, Vec3 dest) {
        return unit(grid.sub(MIDDLE, dest));
      }
    };
  }

  private static AnalyticSurface cylinder(Vec3 direction, double radius) {
    Vec3 axis = unit(new Vec3().set(direction));
    return new AnalyticSurface() {
      @Override
      public double signedDistance(Vec3 grid) {
        return fromAxis(grid, new Vec3()).length() - radius;
      }

      @Override
      public Vec3 normal(Vec3 grid, Vec3 dest) {
        return unit(fromAxis(grid, dest));
      }

      private Vec3 fromAxis(Vec3 grid, Vec3 dest) {
        grid.sub(MIDDLE, dest);
        return dest.sub(axis.mul(dest.dot(axis), new Vec3()), dest);
      }
    };
  }

  private static AnalyticSurface plane(Vec3 up) {
    Vec3 normal = unit(new Vec3().set(up));
    return new AnalyticSurface() {
      @Override
      public double signedDistance(Vec3 grid) {
        return grid.sub(MIDDLE, new Vec3()).dot(normal);
      }

      @Override
      public Vec3 normal(Vec3 grid, Vec3 dest) {
        return dest.set(normal);
      }
    };
  }

  /** Returns a box whose distance is exact inside, and outside where a face is nearest. */
  private static AnalyticSurface box(Vec3 low, Vec3 high) {
    return new AnalyticSurface() {
      @Override
      public double signedDistance(Vec3 grid) {
        int axis = nearestFace(grid);
        return beyond(grid, axis);
      }

      @Override
      public Vec3 normal(Vec3 grid, Vec3 dest) {
        int axis = nearestFace(grid);
        double middle = 0.5 * (low.get(axis) + high.get(axis));
        dest.set(0, 0, 0);
        dest.set(axis, grid.get(axis) > middle ? 1 : -1);
        return dest;
      }

      private int nearestFace(Vec3 grid) {
        double x = beyond(grid, 0);
        double y = beyond(grid, 1);
        double z = beyond(grid, 2);
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
      }

      private double beyond(Vec3 grid, int axis) {
        return Math.max(low.get(axis) - grid.get(axis), grid.get(axis) - high.get(axis));
      }
    };
  }

  private static Vec3 unit(Vec3 direction) {
    return direction.mul(1 / direction.length(), direction);
  }
}
