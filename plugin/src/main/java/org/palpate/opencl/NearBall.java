package org.palpate.opencl;

import java.util.SplittableRandom;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.volume.BitCube;

/**
 * Points close above a ball of voxels, and short motions of them, for measurements of time. No leg
 * of these points would be culled. Grid coordinates.
 */
final class NearBall extends PointArrays {
  private static final int SIZE = 128;
  private static final double RADIUS = 50;
  private static final double HIGHEST_VOXELS = 3;
  private static final long SEED = 1;

  private final BitCube voxels = new BitCube(SIZE, SIZE, SIZE);

  /** Makes a number of points. */
  NearBall(int count) {
    super(count);
    fillBall();
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < count; n++) {
      double height = RADIUS + HIGHEST_VOXELS * random.nextDouble();
      double up = random.nextDouble(-1, 1);
      double angle = random.nextDouble(2 * Math.PI);
      double around = Math.sqrt(1 - up * up);
      x[n] = height * around * Math.cos(angle);
      y[n] = height * around * Math.sin(angle);
      z[n] = height * up;
    }
  }

  private void fillBall() {
    for (int k = 0; k < SIZE; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          double a = i + 0.5 - SIZE / 2.0;
          double b = j + 0.5 - SIZE / 2.0;
          double c = k + 0.5 - SIZE / 2.0;
          if (a * a + b * b + c * c <= RADIUS * RADIUS) {
            voxels.set(i, j, k);
          }
        }
      }
    }
  }

  /** Returns the ball. */
  BitCube voxels() {
    return voxels;
  }

  /** Returns motions of all points, each half as long as the one before. */
  MotionGroup motions(int count) {
    AffineMap map = new AffineMap();
    map.offsetX = map.offsetY = map.offsetZ = SIZE / 2.0;
    MotionGroup group = new MotionGroup();
    group.begin(map);
    for (int n = 0; n < count; n++) {
      map.offsetX = SIZE / 2.0 + 0.31 / (1 << n);
      map.offsetY = SIZE / 2.0 - 0.23 / (1 << n);
      map.offsetZ = SIZE / 2.0 + 0.17 / (1 << n);
      group.add(map);
    }
    return group;
  }
}
