package org.palpate.rigid;

/**
 * The contacts with which the next step begins: those that were active in the last one, then those
 * that were near. Haptic thread only; allocates nothing.
 */
final class KeptContacts {
  private static final int CAPACITY = 40;

  /** The number of the pair. */
  final int[] body = new int[CAPACITY];

  final int[] point = new int[CAPACITY];
  private int count;
  private int active;

  void clear() {
    count = 0;
    active = 0;
  }

  int count() {
    return count;
  }

  /** Returns the number of contacts, at the begin of the list, that were active. */
  int active() {
    return active;
  }

  /** Adds a contact unless it is there already or there are too many. */
  void add(int ofBody, int ofPoint) {
    for (int n = 0; n < count; n++) {
      if (point[n] == ofPoint && body[n] == ofBody) {
        return;
      }
    }
    if (count < CAPACITY) {
      body[count] = ofBody;
      point[count++] = ofPoint;
    }
  }

  /** Counts all contacts so far as active, and those that follow as near. */
  void endActive() {
    active = count;
  }
}
