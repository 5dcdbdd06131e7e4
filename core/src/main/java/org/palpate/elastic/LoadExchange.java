package org.palpate.elastic;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Hands the load of each frame from the haptic thread to the thread of the updates: the last whole
 * one wins. The writer never waits; the reader tries again while the writer writes.
 *
 * <p>Reference: Boehm 2012, "Can seqlocks get along with programming language memory models?".
 */
final class LoadExchange {
  private static final VarHandle SEQUENCE;
  private static final VarHandle VALUES = MethodHandles.arrayElementVarHandle(double[].class);

  static {
    try {
      SEQUENCE = MethodHandles.lookup().findVarHandle(LoadExchange.class, "sequence", int.class);
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  @SuppressWarnings("unused") // by SEQUENCE
  private int sequence;

  private final double[] values = new double[6];

  /** Writes a load. Haptic thread. */
  void write(ElasticLoad load) {
    int next = (int) SEQUENCE.getOpaque(this) + 1;
    SEQUENCE.setOpaque(this, next);
    VarHandle.storeStoreFence();
    for (int axis = 0; axis < 3; axis++) {
      VALUES.setOpaque(values, axis, load.point.get(axis));
      VALUES.setOpaque(values, 3 + axis, load.forceNewton.get(axis));
    }
    SEQUENCE.setRelease(this, next + 1);
  }

  /** Reads the last load. Thread of the updates. */
  void read(ElasticLoad dest) {
    while (true) {
      int before = (int) SEQUENCE.getAcquire(this);
      for (int axis = 0; axis < 3; axis++) {
        dest.point.set(axis, (double) VALUES.getOpaque(values, axis));
        dest.forceNewton.set(axis, (double) VALUES.getOpaque(values, 3 + axis));
      }
      VarHandle.loadLoadFence();
      if ((before & 1) == 0 && before == (int) SEQUENCE.getOpaque(this)) {
        return;
      }
      Thread.onSpinWait();
    }
  }
}
