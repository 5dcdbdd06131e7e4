package org.palpate.sync;

/** A colour with opacity as 0xAARRGGBB. Starts at 0, which is wholly transparent. */
public final class ColourProperty extends Property {
  ColourProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 1);
  }

  /** Sets the colour, 0xAARRGGBB. Writer. */
  public void set(int argb) {
    put(0, (long) argb);
    settle();
  }

  /** The value as last taken, 0xAARRGGBB. Reader. */
  public int read() {
    return (int) taken(0);
  }
}
