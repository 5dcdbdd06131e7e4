package org.palpate.rigid;

/**
 * The contacts that one step of a rigid tool hands to the next: first those that held the tool back
 * (active), then those that were near it. Haptic thread only; allocates nothing.
 */
final class KeptContacts {
  private static final int CAPACITY = 40;

  /** For each contact the number of its pair, see {@link MoverVerifier}. */
  final int[] body = new int[CAPACITY];

  /** For each contact the index of its sample point. */
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

  /**
   * Returns the number of contacts, at the beginning of the list, that were active in the last
   * step.
   */
  int active() {
    return active;
  }

  /** Adds a contact, unless it is in the list already or the list is full. */
  void add(int ofPair, int ofPoint) {
    for (int n = 0; n < count; n++) {
      if (point[n] == ofPoint && body[n] == ofPair) {
        return;
      }
    }
    if (count < CAPACITY) {
      body[count] = ofPair;
      point[count++] = ofPoint;
    }
  }

  /** Ends the active contacts; those that are added from now on were only near. */
  void endActive() {
    active = count;
  }
}
