package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * A property of the scene that crosses from the haptic thread to the synchronization thread, held
 * as words in an {@link Accumulator}. What sets belongs to the writer, what reads to the reader.
 */
public abstract sealed class Property
    permits PositionProperty,
        TransformProperty,
        NumberProperty,
        ColourProperty,
        VisibilityProperty,
        LinesProperty,
        TouchProperty,
        TextProperty {
  private final Accumulator accumulator;
  private final String name;
  private final int index;
  private final int offset;
  private final int words;

  /** Whether a word changed since {@link #settle}. The writer's. */
  private boolean changed;

  Property(Accumulator accumulator, String name, int index, int offset, int words) {
    this.accumulator = accumulator;
    this.name = name;
    this.index = index;
    this.offset = offset;
    this.words = words;
  }

  public final String name() {
    return name;
  }

  /** Whether what was taken differs from what was last applied. Reader. */
  public final boolean isDirty() {
    return accumulator.isPending(this);
  }

  /** Says that the value as last taken is in the scene. Reader. */
  public final void applied() {
    accumulator.markApplied(this);
  }

  final int index() {
    return index;
  }

  final int offset() {
    return offset;
  }

  final int words() {
    return words;
  }

  final void put(int word, long value) {
    changed |= accumulator.put(offset + word, value);
  }

  final void put(int word, double value) {
    put(word, Double.doubleToRawLongBits(value));
  }

  /** Three doubles that are the whole value. */
  final void putAll(double x, double y, double z) {
    long a = Double.doubleToRawLongBits(x);
    long b = Double.doubleToRawLongBits(y);
    long c = Double.doubleToRawLongBits(z);
    if (accumulator.put(offset, a, b, c)) {
      accumulator.changed(this);
    }
  }

  /** The words of a {@link TouchProperty}. */
  final void putTouch(Vec3 device, Vec3 point, Vec3 force, long contact, long frame) {
    if (accumulator.putTouch(offset, device, point, force, contact, frame)) {
      accumulator.changed(this);
    }
  }

  /** Ends a value's puts: it is one change, where any word differed. */
  final void settle() {
    if (changed) {
      changed = false;
      accumulator.changed(this);
    }
  }

  final long taken(int word) {
    return accumulator.taken(offset + word);
  }

  final double takenDouble(int word) {
    return Double.longBitsToDouble(taken(word));
  }
}
