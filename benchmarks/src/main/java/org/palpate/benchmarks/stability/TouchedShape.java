package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.function.IntPredicate;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * A shape that the hand presses on, in voxels of half a millimetre.
 *
 * @param name the name in tables
 * @param scene the solids
 * @param touchMm a point of the surface
 * @param inward the unit direction into the solid
 */
public record TouchedShape(String name, CollisionScene scene, Vec3 touchMm, Vec3 inward) {
  /** The edge of a voxel. */
  public static final double VOXEL_MM = 0.5;

  private static final int EDGE = 128;
  private static final int MIDDLE = EDGE / 2;

  /** The radius of the sphere in voxels: twice the intended depth of the hand. */
  private static final int RADIUS = 55;

  /** A rule for solid voxels. */
  private interface Solid {
    boolean at(int i, int j, int k);
  }

  /** Returns every shape of the study. */
  public static List<TouchedShape> all() {
    return List.of(wall(), corner(), groove(), sphere(), head());
  }

  /** Returns a flat wall across z, pressed a third of a voxel beside the middle. */
  public static TouchedShape wall() {
    return of(
        "wall",
        (i, j, k) -> k < MIDDLE,
        new Vec3(MIDDLE + 0.3, MIDDLE - 0.4, MIDDLE),
        new Vec3(0, 0, -1));
  }

  private static TouchedShape corner() {
    return of(
        "corner",
        (i, j, k) -> k < MIDDLE || i < MIDDLE,
        new Vec3(MIDDLE, MIDDLE - 0.4, MIDDLE),
        unit(-1, 0, -1));
  }

  /** Returns a groove three voxels wide and deep. */
  private static TouchedShape groove() {
    return of(
        "groove",
        (i, j, k) -> k < MIDDLE - 3 || (k < MIDDLE && Math.abs(i - MIDDLE) > 1),
        new Vec3(MIDDLE + 0.5, MIDDLE - 0.4, MIDDLE - 3),
        unit(0.2, 0, -1));
  }

  private static TouchedShape sphere() {
    IntPredicate inside = square -> square <= RADIUS * RADIUS;
    return of(
        "sphere",
        (i, j, k) ->
            inside.test(
                (i - MIDDLE) * (i - MIDDLE)
                    + (j - MIDDLE) * (j - MIDDLE)
                    + (k - MIDDLE) * (k - MIDDLE)),
        new Vec3(MIDDLE + 0.5 + RADIUS * 0.6, MIDDLE + 0.5, MIDDLE + 0.5 + RADIUS * 0.8),
        unit(-0.6, 0, -0.8));
  }

  /** Returns the skin of the head phantom, pressed from above. */
  private static TouchedShape head() {
    Phantom head = Phantom.parse("head:" + EDGE);
    List<BitCube> cubes =
        head.segments().segments().stream().map(segment -> segment.bits()).toList();
    CollisionScene scene = new CollisionScene(cubes);
    int top = EDGE - 1;
    while (top > 0 && !scene.isSolid(MIDDLE, MIDDLE, top)) {
      top--;
    }
    return new TouchedShape(
        "head", scene, toMm(new Vec3(MIDDLE + 0.3, MIDDLE + 0.4, top + 1)), new Vec3(0, 0, -1));
  }

  private static TouchedShape of(String name, Solid solid, Vec3 touchGrid, Vec3 inward) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (solid.at(i, j, k)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return new TouchedShape(name, new CollisionScene(List.of(bits)), toMm(touchGrid), inward);
  }

  private static Vec3 toMm(Vec3 grid) {
    return grid.mul(VOXEL_MM, grid);
  }

  private static Vec3 unit(double x, double y, double z) {
    Vec3 direction = new Vec3(x, y, z);
    return direction.mul(1 / direction.length(), direction);
  }
}
