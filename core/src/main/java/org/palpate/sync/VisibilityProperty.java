package org.palpate.sync;

/** Whether something is shown. Starts as false. */
public final class VisibilityProperty extends Property {
  VisibilityProperty(Accumulator accumulator, String name, int index, int offset) {
    super(accumulator, name, index, offset, 1);
  }

  /** Shows or hides. Writer. */
  public void set(boolean visible) {
    put(0, visible ? 1L : 0L);
    settle();
  }

  /** The value as last taken. Reader. */
  public boolean read() {
    return taken(0) != 0;
  }
}
