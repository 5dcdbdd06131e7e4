package org.palpate.elastic;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Hands fields from one writer to one reader by three buffers and one atomic exchange. Neither
 * waits, and the reader always has a whole field.
 */
final class FieldExchange {
  private static final int FRESH = 4;
  private static final int INDEX = 3;

  private final DeformationField[] fields = new DeformationField[3];
  private final AtomicInteger middle = new AtomicInteger(1);
  private int back;
  private int front = 2;

  /** Makes three fields without displacement. */
  FieldExchange(DeformationField.Layout layout) {
    for (int n = 0; n < fields.length; n++) {
      fields[n] = new DeformationField(layout);
    }
  }

  /** Returns the field to write. Writer. */
  DeformationField back() {
    return fields[back];
  }

  /** Hands the written field over. Writer. */
  void publish() {
    back = middle.getAndSet(back | FRESH) & INDEX;
  }

  /** Returns the field that was taken last. Reader. */
  DeformationField front() {
    return fields[front];
  }

  /** Whether there is a field since the last one that was taken. Reader. */
  boolean hasNew() {
    return (middle.get() & FRESH) != 0;
  }

  /** Takes the newest field, if there is one, and gives the last one back. Reader. */
  void take() {
    if (hasNew()) {
      front = middle.getAndSet(front) & INDEX;
    }
  }
}
