package org.palpate.sync;

/** A text of up to a fixed number of chars, four to a word; longer texts are cut. Starts empty. */
public final class TextProperty extends Property {
  private static final int CHARS_A_WORD = 4;

  private final int capacity;

  TextProperty(Accumulator accumulator, String name, int index, int offset, int capacity) {
    super(accumulator, name, index, offset, 1 + (capacity + CHARS_A_WORD - 1) / CHARS_A_WORD);
    if (capacity < 1) {
      throw new IllegalArgumentException("capacity must be at least 1: capacity=" + capacity);
    }
    this.capacity = capacity;
  }

  public int capacity() {
    return capacity;
  }

  /** Copies the text; allocates nothing. Writer. */
  public void set(CharSequence text) {
    int length = Math.min(text.length(), capacity);
    put(0, (long) length);
    for (int at = 0; at < length; at += CHARS_A_WORD) {
      put(1 + at / CHARS_A_WORD, packed(text, at, length));
    }
    settle();
  }

  private static long packed(CharSequence text, int from, int length) {
    long word = 0;
    for (int i = from; i < Math.min(from + CHARS_A_WORD, length); i++) {
      word |= (long) text.charAt(i) << (16 * (i - from));
    }
    return word;
  }

  /** The text as last taken; allocates. Reader. */
  public String read() {
    char[] chars = new char[(int) taken(0)];
    for (int i = 0; i < chars.length; i++) {
      chars[i] = (char) (taken(1 + i / CHARS_A_WORD) >>> (16 * (i % CHARS_A_WORD)));
    }
    return new String(chars);
  }
}
