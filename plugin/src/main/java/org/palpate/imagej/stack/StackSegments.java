package org.palpate.imagej.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.IntConsumer;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

/** Builds bit cubes from a stack, slice by slice. Any one thread; the stack is only read. */
public final class StackSegments {
  /** The most values of a label image; more are grey values. */
  static final int MAX_LABELS = 256;

  private StackSegments() {}

  /** Provides slices: a stack, or a copy of it. */
  @FunctionalInterface
  public interface Slices {
    /** Returns the pixels of slice k, counted from 0, as {@link StackVolume#pixels} does. */
    Object slice(int k) throws TouchRefusedException;
  }

  /**
   * Builds one segment for each range, in the order of the ranges.
   *
   * @param progress receives the number of each finished slice, from 0
   */
  public static List<Segment> of(
      StackVolume volume, Slices slices, List<SegmentRange> ranges, IntConsumer progress)
      throws TouchRefusedException {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < ranges.size(); n++) {
      cubes.add(new BitCube(volume.width(), volume.height(), volume.slices()));
    }
    Filler filler = new Filler(ranges, cubes, volume.width());
    for (int k = 0; k < volume.slices(); k++) {
      filler.fill(slices.slice(k), k);
      progress.accept(k);
    }
    List<Segment> segments = new ArrayList<>();
    for (int n = 0; n < ranges.size(); n++) {
      segments.add(new Segment(ranges.get(n).name(), cubes.get(n), ranges.get(n).rgb()));
    }
    return segments;
  }

  /**
   * Sets the bits of a slice. Looks up the matching ranges once for each run of equal values,
   * because labels come in long runs.
   */
  private static final class Filler {
    private final List<SegmentRange> ranges;
    private final List<BitCube> cubes;
    private final int width;
    private final int[] matching;
    private int matchCount;

    private Filler(List<SegmentRange> ranges, List<BitCube> cubes, int width) {
      this.ranges = ranges;
      this.cubes = cubes;
      this.width = width;
      matching = new int[ranges.size()];
    }

    private void fill(Object pixels, int k) {
      float last = Float.NaN;
      int count = StackVolume.pixelCount(pixels);
      for (int n = 0; n < count; n++) {
        float value = StackVolume.value(pixels, n);
        if (value != last) {
          last = value;
          lookUp(value);
        }
        for (int h = 0; h < matchCount; h++) {
          cubes.get(matching[h]).set(n % width, n / width, k);
        }
      }
    }

    private void lookUp(float value) {
      matchCount = 0;
      for (int n = 0; n < ranges.size(); n++) {
        if (ranges.get(n).contains(value)) {
          matching[matchCount++] = n;
        }
      }
    }
  }

  /**
   * Returns the values other than 0 of a label image.
   *
   * @throws TouchRefusedException if a value is not a whole number of at least 0, or there are none
   *     or more than {@link #MAX_LABELS}
   */
  public static SortedSet<Integer> labels(StackVolume volume) throws TouchRefusedException {
    SortedSet<Integer> labels = new TreeSet<>();
    float last = 0;
    for (int k = 0; k < volume.slices(); k++) {
      Object slice = volume.pixels(k);
      int count = StackVolume.pixelCount(slice);
      for (int n = 0; n < count; n++) {
        float value = StackVolume.value(slice, n);
        if (value != last) {
          last = value;
          add(labels, value);
        }
      }
    }
    if (labels.isEmpty()) {
      throw new TouchRefusedException(
          "Every voxel is 0, the background: there is nothing to touch.");
    }
    return labels;
  }

  private static void add(SortedSet<Integer> labels, float value) throws TouchRefusedException {
    if (value < 0 || value != (int) value) {
      throw new TouchRefusedException(
          "The value "
              + value
              + " is not a label: labels are whole numbers from 0. Use a threshold instead.");
    }
    if (value > 0) {
      labels.add((int) value);
    }
    if (labels.size() > MAX_LABELS) {
      throw new TouchRefusedException(
          "There are more than "
              + MAX_LABELS
              + " values: these are grey values, not labels. Use a threshold instead.");
    }
  }
}
