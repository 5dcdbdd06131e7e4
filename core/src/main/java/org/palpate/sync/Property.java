package org.palpate.sync;

import org.palpate.geometry.Vec3;

/**
 * A property of the scene that crosses from the haptic thread to the synchronization thread. Its
 * value is a row of words in an {@link Accumulator}.
 *
 * <p>Methods that set are for the writer, methods that read for the reader.
 */
public abstract sealed class Property
    permits PositionProperty, TransformProperty, NumberProperty, TouchProperty {
  private final Accumulator accumulator;
  private final String name;
  private final int index;
  private final int offset;
  private final int words;

  /** Whether a word changed after the last {@link #settle}. Writer. */
  private boolean changed;

  Property(Accumulator accumulator, String name, int index, int offset, int words) {
    this.accumulator = accumulator;
    this.name = name;
    this.index = index;
    this.offset = offset;
    this.words = words;
  }

  /** {@return the name of the property, for messages} */
  public final String name() {
    return name;
  }

  /** {@return whether the value that was last taken differs from the one last applied} Reader. */
  public final boolean isDirty() {
    return accumulator.isPending(this);
  }

  /** Marks the value that was last taken as applied to the scene. Reader. */
  public final void markApplied() {
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

  private void put(int word, long value) {
    changed |= accumulator.put(offset + word, value);
  }

  /** Writes one word of the value. {@link #settle} must follow before the publication. */
  final void put(int word, double value) {
    put(word, Double.doubleToRawLongBits(value));
  }

  /** Writes three doubles that are the whole value. */
  final void putAll(double x, double y, double z) {
    long a = Double.doubleToRawLongBits(x);
    long b = Double.doubleToRawLongBits(y);
    long c = Double.doubleToRawLongBits(z);
    boolean written = accumulator.put(offset, a, b, c);
    if (written) {
      accumulator.countChange(this);
    }
  }

  /** Writes the whole value of a {@link TouchProperty}. */
  final void putTouch(Vec3 device, Vec3 point, Vec3 force, long contact, long frame) {
    boolean written = accumulator.putTouch(offset, device, point, force, contact, frame);
    if (written) {
      accumulator.countChange(this);
    }
  }

  /** Ends a series of {@link #put}: it counts as one change if any word differs. */
  final void settle() {
    if (changed) {
      changed = false;
      accumulator.countChange(this);
    }
  }

  final long taken(int word) {
    return accumulator.taken(offset + word);
  }

  final double takenDouble(int word) {
    return Double.longBitsToDouble(taken(word));
  }
}
