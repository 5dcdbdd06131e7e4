package org.palpate.raycast;

/** Makes rays for tests that are the same along each axis. */
final class TurnedRay {
  private TurnedRay() {}

  /**
   * Returns a ray whose first component runs along an axis, and the others along the next two.
   *
   * @param axis 0 to 2
   * @param from three components of its start
   * @param to three components of its end
   */
  static Ray of(int axis, double[] from, double[] to) {
    double[] at = new double[6];
    for (int n = 0; n < 3; n++) {
      at[(axis + n) % 3] = from[n];
      at[3 + (axis + n) % 3] = to[n];
    }
    return new Ray().from(at[0], at[1], at[2]).to(at[3], at[4], at[5]);
  }
}
