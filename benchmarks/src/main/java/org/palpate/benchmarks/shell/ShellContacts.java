package org.palpate.benchmarks.shell;

import org.palpate.raycast.RayHit;

/**
 * Contact flags and hits of a shell's points. {@link ShellCollider} writes them; several threads
 * may write ranges that do not overlap.
 */
public final class ShellContacts {
  private final boolean[] contact;
  private final double[] t;
  private final int[] voxels;
  private final byte[] axes;

  /** Creates contacts for a number of points, all without contact. */
  public ShellContacts(int points) {
    contact = new boolean[points];
    t = new double[points];
    voxels = new int[3 * points];
    axes = new byte[points];
  }

  /** Whether the segment from a point's previous to its present position touches a solid. */
  public boolean isContact(int point) {
    return contact[point];
  }

  /** Returns the number of points with contact. */
  public int count() {
    int count = 0;
    for (boolean one : contact) {
      count += one ? 1 : 0;
    }
    return count;
  }

  /** Writes the hit of a point with contact; {@code t} is a fraction of its segment. */
  public void hit(int point, RayHit dest) {
    dest.set(
        t[point], voxels[3 * point], voxels[3 * point + 1], voxels[3 * point + 2], axes[point]);
  }

  void put(int point, RayHit hit) {
    contact[point] = true;
    t[point] = hit.t;
    voxels[3 * point] = hit.i;
    voxels[3 * point + 1] = hit.j;
    voxels[3 * point + 2] = hit.k;
    axes[point] = (byte) hit.axis;
  }

  void clear(int point) {
    contact[point] = false;
  }
}
