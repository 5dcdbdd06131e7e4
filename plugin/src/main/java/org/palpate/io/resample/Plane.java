package org.palpate.io.resample;

import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;

/**
 * A plane in the world.
 *
 * @param pointMm a point of the plane, mm
 * @param normal its normal, a unit vector
 */
public record Plane(Vec3 pointMm, Vec3 normal) {

  /**
   * Reads {@code X,Y,Z,NX,NY,NZ}: a point, mm, and a normal of any length but 0. Empty if the text
   * has another form.
   */
  public static Optional<Plane> parse(String text) {
    String[] words = text.split(",", -1);
    if (words.length != 6) {
      return Optional.empty();
    }
    Vec3 point = new Vec3();
    Vec3 normal = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      point.set(axis, NumberParser.number(words[axis]));
      normal.set(axis, NumberParser.number(words[3 + axis]));
    }
    double length = normal.length();
    if (!point.isFinite() || !(length > 0 && Double.isFinite(length))) {
      return Optional.empty();
    }
    return Optional.of(new Plane(point, normal.mul(1 / length, normal)));
  }
}
