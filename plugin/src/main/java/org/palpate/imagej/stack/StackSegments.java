package org.palpate.imagej.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.IntConsumer;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

/** Makes bit cubes of a stack, slice by slice. Any one thread; the stack is only read. */
public final class StackSegments {
  /** More labels than this are no labels but grey values. */
  static final int MOST_LABELS = 256;

  private StackSegments() {}

  /** Where slices come from: a stack, or a copy of it. */
  @FunctionalInterface
  public interface Slices {
    /** The pixels of slice k, from 0, as {@link StackVolume#pixels} has them. */
    Object slice(int k) throws TouchRefusedException;
  }

  /**
   * One segment a rule, in the rules' order.
   *
   * @param progress told of each slice that is done, from 0
   */
  public static List<Segment> of(
      StackVolume volume, Slices slices, List<SegmentRange> rules, IntConsumer progress)
      throws TouchRefusedException {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < rules.size(); n++) {
      cubes.add(new BitCube(volume.width(), volume.height(), volume.slices()));
    }
    Filler filler = new Filler(rules, cubes, volume.width());
    for (int k = 0; k < volume.slices(); k++) {
      filler.fill(slices.slice(k), k);
      progress.accept(k);
    }
    List<Segment> segments = new ArrayList<>();
    for (int n = 0; n < rules.size(); n++) {
      segments.add(new Segment(rules.get(n).name(), cubes.get(n), rules.get(n).rgb()));
    }
    return segments;
  }

  /** Looks up which rules hold once for a run of pixels of one value: labels come in long runs. */
  private static final class Filler {
    private final List<SegmentRange> rules;
    private final List<BitCube> cubes;
    private final int width;
    private final int[] holding;
    private int held;

    private Filler(List<SegmentRange> rules, List<BitCube> cubes, int width) {
      this.rules = rules;
      this.cubes = cubes;
      this.width = width;
      holding = new int[rules.size()];
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
        for (int h = 0; h < held; h++) {
          cubes.get(holding[h]).set(n % width, n / width, k);
        }
      }
    }

    private void lookUp(float value) {
      held = 0;
      for (int n = 0; n < rules.size(); n++) {
        if (rules.get(n).holds(value)) {
          holding[held++] = n;
        }
      }
    }
  }

  /**
   * The values other than 0 of a label image.
   *
   * @throws TouchRefusedException where a value is no whole number from 0, or there are more than
   *     {@link #MOST_LABELS}, or none
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
              + " is no label: labels are whole numbers from 0. Use a threshold instead.");
    }
    if (value > 0) {
      labels.add((int) value);
    }
    if (labels.size() > MOST_LABELS) {
      throw new TouchRefusedException(
          "There are more than "
              + MOST_LABELS
              + " values: these are grey values, no labels. Use a threshold instead.");
    }
  }
}
