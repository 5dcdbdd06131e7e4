package org.palpate.rigid;

import org.palpate.geometry.Vec3;

/**
 * The contacts that carry a tool: those whose constraints held it back in the last frame that was
 * solved. Written by the solver, in the haptic thread.
 */
public final class ToolContacts {
  /** The most contacts that can be active together: one for each unknown of the problem. */
  public static final int MOST = 7;

  final int[] body = new int[MOST];
  final double[] x = new double[MOST];
  final double[] y = new double[MOST];
  final double[] z = new double[MOST];
  final double[] share = new double[MOST];
  final double[] heightMm = new double[MOST];
  final double[] normalX = new double[MOST];
  final double[] normalY = new double[MOST];
  final double[] normalZ = new double[MOST];
  int count;

  /** {@return the number of contacts} */
  public int count() {
    return count;
  }

  /**
   * {@return the index of the touched body in its scene}
   *
   * @param contact the number of the contact, from 0 to {@link #count} - 1
   */
  public int body(int contact) {
    return body[contact];
  }

  /**
   * Writes where the tool is touched.
   *
   * @param contact the number of the contact, from 0 to {@link #count} - 1
   * @param dest receives the position, tool frame, mm
   * @return {@code dest}
   */
  public Vec3 position(int contact, Vec3 dest) {
    return dest.set(x[contact], y[contact], z[contact]);
  }

  /**
   * {@return the part of the pressing force that the contact carries; all parts add up to 1}
   *
   * @param contact the number of the contact, from 0 to {@link #count} - 1
   */
  public double share(int contact) {
    return share[contact];
  }

  /**
   * {@return the height of the touched point over the surface of the body, mm: hardly more than 0
   * in mode {@code points}, and at least the clearance that the point keeps in mode {@code body}}
   *
   * @param contact the number of the contact, from 0 to {@link #count} - 1
   */
  public double heightMm(int contact) {
    return heightMm[contact];
  }

  /**
   * Writes the normal of the surface, out of the body.
   *
   * @param contact the number of the contact, from 0 to {@link #count} - 1
   * @param dest receives the normal, unit, world axes
   * @return {@code dest}
   */
  public Vec3 normal(int contact, Vec3 dest) {
    return dest.set(normalX[contact], normalY[contact], normalZ[contact]);
  }

  void clear() {
    count = 0;
  }

  /** Adds a contact whose share is still the multiplier of its constraint. */
  void add(int ofBody, Vec3 position, Vec3 normal, double aboveMm, double multiplier) {
    if (count < MOST) {
      body[count] = ofBody;
      x[count] = position.x;
      y[count] = position.y;
      z[count] = position.z;
      normalX[count] = normal.x;
      normalY[count] = normal.y;
      normalZ[count] = normal.z;
      heightMm[count] = aboveMm;
      share[count++] = multiplier;
    }
  }

  /** Turns multipliers into shares. */
  void normalizeShares() {
    double sum = 0;
    for (int n = 0; n < count; n++) {
      sum += share[n];
    }
    for (int n = 0; n < count; n++) {
      share[n] = sum > 0 ? share[n] / sum : 1.0 / count;
    }
  }
}
