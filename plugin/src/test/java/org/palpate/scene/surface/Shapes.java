package org.palpate.scene.surface;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** Shapes and complete surfaces for tests. */
final class Shapes {
  static final Vec3 UNIT = new Vec3(1, 1, 1);

  private Shapes() {}

  /** The solid points, by grid coordinates of a voxel's middle. */
  interface Solid {
    boolean contains(double x, double y, double z);
  }

  static BitCube cube(int sizeX, int sizeY, int sizeZ, Solid solid) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          if (solid.contains(i + 0.5, j + 0.5, k + 0.5)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  static BitCube sphere(int edge, double radius) {
    double middle = edge / 2.0;
    return cube(
        edge,
        edge,
        edge,
        (x, y, z) ->
            square(x - middle) + square(y - middle) + square(z - middle) <= radius * radius);
  }

  static BitCube random(int sizeX, int sizeY, int sizeZ, double fraction, Random random) {
    return cube(sizeX, sizeY, sizeZ, (x, y, z) -> random.nextDouble() < fraction);
  }

  static double square(double value) {
    return value * value;
  }

  static List<SurfaceBrick> bricks(SurfaceSource source, int brickEdge) {
    SurfaceExtractor extractor = new SurfaceExtractor(brickEdge);
    List<SurfaceBrick> bricks = new ArrayList<>();
    for (int brick = 0; brick < extractor.layout(source).count(); brick++) {
      SurfaceBrick mesh = extractor.extract(source, AmbientOcclusion.NONE, brick);
      if (mesh != null) {
        bricks.add(mesh);
      }
    }
    return bricks;
  }

  static WeldedSurface surface(SurfaceSource source) {
    return WeldedSurface.of(bricks(source, SurfaceExtractor.BRICK_EDGE));
  }

  static long seed() {
    String given = System.getProperty("palpate.seed", "");
    return given.isBlank() || given.startsWith("$") ? 20130701L : Long.parseLong(given);
  }
}
