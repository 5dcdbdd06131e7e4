package org.palpate.body;

/** The locks of the bodies of a scene, and the groups that move together. Immutable. */
public final class BodyGroups {
  /** The smallest index of the bodies that move together with each. */
  private final int[] first;

  private final boolean[] locked;

  private BodyGroups(int[] first, boolean[] locked) {
    this.first = first;
    this.locked = locked;
  }

  /**
   * {@return groups in which each of a number of bodies moves alone and none is locked}
   *
   * @param bodies the number of bodies
   */
  public static BodyGroups none(int bodies) {
    int[] first = new int[bodies];
    for (int n = 0; n < bodies; n++) {
      first[n] = n;
    }
    return new BodyGroups(first, new boolean[bodies]);
  }

  /**
   * {@return whether two bodies move together; each does with itself}
   *
   * @param one the index of a body in the scene
   * @param other the index of a body, perhaps the same
   */
  public boolean moveTogether(int one, int other) {
    return first[one] == first[other];
  }

  /**
   * {@return the number of bodies that move together with one, at least 1}
   *
   * @param body the index of a body in the scene
   */
  public int size(int body) {
    int size = 0;
    for (int n = 0; n < first.length; n++) {
      size += moveTogether(body, n) ? 1 : 0;
    }
    return size;
  }

  /**
   * {@return whether a body, or one that moves together with it, is locked, so that no hand takes
   * it}
   *
   * @param body the index of a body in the scene
   */
  public boolean isLocked(int body) {
    for (int n = 0; n < first.length; n++) {
      if (locked[n] && moveTogether(body, n)) {
        return true;
      }
    }
    return false;
  }

  /**
   * {@return groups in which a body and all bodies that move together with it are locked, or
   * unlocked}
   *
   * @param body the index of a body in the scene
   * @param isLocked whether no hand takes them from now on
   */
  public BodyGroups withLock(int body, boolean isLocked) {
    boolean[] changed = locked.clone();
    for (int n = 0; n < first.length; n++) {
      changed[n] = moveTogether(body, n) ? isLocked : locked[n];
    }
    return new BodyGroups(first, changed);
  }

  /**
   * {@return groups in which the group of one body is merged with that of another}
   *
   * @param one the index of a body in the scene
   * @param other the index of another body
   */
  public BodyGroups bound(int one, int other) {
    int joint = Math.min(first[one], first[other]);
    int[] changed = first.clone();
    for (int n = 0; n < first.length; n++) {
      changed[n] = moveTogether(one, n) || moveTogether(other, n) ? joint : first[n];
    }
    return new BodyGroups(changed, locked);
  }

  /**
   * {@return groups in which a body moves alone}
   *
   * @param body the index of the body in the scene
   */
  public BodyGroups alone(int body) {
    int heir = -1;
    int[] changed = first.clone();
    for (int n = 0; n < first.length; n++) {
      if (n != body && moveTogether(body, n)) {
        heir = heir < 0 ? n : heir;
        changed[n] = heir;
      }
    }
    changed[body] = body;
    return new BodyGroups(changed, locked);
  }
}
