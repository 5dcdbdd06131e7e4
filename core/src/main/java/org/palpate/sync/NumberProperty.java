package org.palpate.sync;

/** A single double: a rate, a length, a count. Starts at zero. */
public final class NumberProperty extends Property {
  NumberProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 1);
  }

  /** Sets the number. Writer. */
  public void set(double value) {
    put(0, value);
    settle();
  }

  /** The value as last taken. Reader. */
  public double read() {
    return takenDouble(0);
  }
}
