package org.palpate.benchmarks.shell;

import org.palpate.raycast.RayHit;

/**
 * Which points of a shell met a solid, and where. Written by {@link ShellCollider}; ranges that do
 * not overlap may be written by several threads.
 */
public final class ShellContacts {
  private final boolean[] contact;
  private final double[] t;
  private final int[] cells;
  private final byte[] axes;

  /** No contacts, for so many points. */
  public ShellContacts(int points) {
    contact = new boolean[points];
    t = new double[points];
    cells = new int[3 * points];
    axes = new byte[points];
  }

  /** Whether the straight way of a point from where it was to where it is touches a solid. */
  public boolean isContact(int point) {
    return contact[point];
  }

  /** The number of points with contact. */
  public int count() {
    int count = 0;
    for (boolean one : contact) {
      count += one ? 1 : 0;
    }
    return count;
  }

  /** Writes where a point with contact met the solid, as a share of its way. */
  public void hit(int point, RayHit dest) {
    dest.set(t[point], cells[3 * point], cells[3 * point + 1], cells[3 * point + 2], axes[point]);
  }

  void put(int point, RayHit hit) {
    contact[point] = true;
    t[point] = hit.t;
    cells[3 * point] = hit.i;
    cells[3 * point + 1] = hit.j;
    cells[3 * point + 2] = hit.k;
    axes[point] = (byte) hit.axis;
  }

  void clear(int point) {
    contact[point] = false;
  }
}
