package org.palpate.sync;

/** A property that is a single double, for example a rate or a length. Starts at zero. */
public final class NumberProperty extends Property {
  NumberProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 1);
  }

  /**
   * Sets the number. Writer.
   *
   * @param value the new number
   */
  public void set(double value) {
    put(0, value);
    settle();
  }

  /** {@return the value that was last taken} Reader. */
  public double read() {
    return takenDouble(0);
  }
}
