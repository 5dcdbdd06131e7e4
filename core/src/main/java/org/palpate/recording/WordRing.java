package org.palpate.recording;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A ring buffer of entries of some words each. A full buffer drops the newest entry and counts it.
 *
 * <p>One writer: it claims an entry, fills its words and publishes it. One reader: it reads the
 * words of the oldest entry and releases it. Neither waits or allocates.
 */
final class WordRing {
  /** The result of {@link #claim} if the buffer is full. */
  static final int FULL = -1;

  /** The number of words of a position and an orientation. */
  static final int WORDS_A_POSE = 7;

  private final long[] words;
  private final int wordsAnEntry;
  private final int capacity;
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();
  private final AtomicLong overflows = new AtomicLong();

  /** Makes an empty buffer for {@code capacity} entries, at least 1. */
  WordRing(int capacity, int wordsAnEntry) {
    this.capacity = capacity;
    this.wordsAnEntry = wordsAnEntry;
    words = new long[Math.multiplyExact(capacity, wordsAnEntry)];
  }

  /** Returns the index of the first word of the next entry, or {@link #FULL}. Writer. */
  int claim() {
    long at = written.getPlain();
    if (at - taken.get() >= capacity) {
      overflows.lazySet(overflows.getPlain() + 1);
      return FULL;
    }
    return firstWord(at);
  }

  /** Publishes the claimed entry. Writer. */
  void publish() {
    written.setRelease(written.getPlain() + 1);
  }

  /** Returns the number of entries that can be read. Reader. */
  int available() {
    return (int) (written.getAcquire() - taken.getPlain());
  }

  /** Returns the index of the first word of the oldest entry. Reader, if one is available. */
  int oldest() {
    return firstWord(taken.getPlain());
  }

  /** Gives the oldest entry back to the writer. Reader. */
  void release() {
    taken.setRelease(taken.getPlain() + 1);
  }

  private int firstWord(long at) {
    return (int) (at % capacity) * wordsAnEntry;
  }

  /** Returns a word. Reader. */
  long get(int at) {
    return words[at];
  }

  /** Sets a word of the claimed entry. Writer. */
  void set(int at, long word) {
    words[at] = word;
  }

  /** Sets three words of the claimed entry, bit for bit. Writer. */
  void set(int at, Vec3 vector) {
    for (int axis = 0; axis < 3; axis++) {
      words[at + axis] = Double.doubleToRawLongBits(vector.get(axis));
    }
  }

  /** Sets {@link #WORDS_A_POSE} words of the claimed entry, bit for bit. Writer. */
  void set(int at, Vec3 position, Quaternion orientation) {
    set(at, position);
    words[at + 3] = Double.doubleToRawLongBits(orientation.w);
    words[at + 4] = Double.doubleToRawLongBits(orientation.x);
    words[at + 5] = Double.doubleToRawLongBits(orientation.y);
    words[at + 6] = Double.doubleToRawLongBits(orientation.z);
  }

  /** Reads three words, bit for bit. Reader. */
  void get(int at, Vec3 dest) {
    for (int axis = 0; axis < 3; axis++) {
      dest.set(axis, number(at + axis));
    }
  }

  /** Reads {@link #WORDS_A_POSE} words, bit for bit. Reader. */
  void get(int at, Vec3 destPosition, Quaternion destOrientation) {
    get(at, destPosition);
    destOrientation.set(number(at + 3), number(at + 4), number(at + 5), number(at + 6));
  }

  private double number(int at) {
    return Double.longBitsToDouble(words[at]);
  }

  /** Returns the number of entries that were dropped because the buffer was full. Any thread. */
  long overflows() {
    return overflows.get();
  }
}
