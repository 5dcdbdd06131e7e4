package org.palpate.imagej;

import ij.process.ImageProcessor;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.IntConsumer;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

/** Makes bit cubes of a stack, slice by slice. Any one thread; the stack is only read. */
final class StackSegments {
  /** More labels than this are no labels but grey values. */
  static final int MOST_LABELS = 256;

  private StackSegments() {}

  /**
   * One segment a rule, in the rules' order.
   *
   * @param progress told of each slice that is done, from 0
   */
  static List<Segment> of(StackVolume volume, List<VoxelRule> rules, IntConsumer progress) {
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < rules.size(); n++) {
      cubes.add(new BitCube(volume.width(), volume.height(), volume.slices()));
    }
    for (int k = 0; k < volume.slices(); k++) {
      ImageProcessor slice = volume.slice(k);
      for (int n = 0; n < rules.size(); n++) {
        fill(cubes.get(n), rules.get(n), slice, k);
      }
      progress.accept(k);
    }
    List<Segment> segments = new ArrayList<>();
    for (int n = 0; n < rules.size(); n++) {
      segments.add(new Segment(rules.get(n).name(), cubes.get(n), rules.get(n).rgb()));
    }
    return segments;
  }

  private static void fill(BitCube cube, VoxelRule rule, ImageProcessor slice, int k) {
    int width = slice.getWidth();
    int pixels = slice.getPixelCount();
    for (int n = 0; n < pixels; n++) {
      if (rule.holds(slice.getf(n))) {
        cube.set(n % width, n / width, k);
      }
    }
  }

  /**
   * The values other than 0 of a label image.
   *
   * @throws StackRefused where a value is no whole number from 0, or there are more than {@link
   *     #MOST_LABELS}, or none
   */
  static SortedSet<Integer> labels(StackVolume volume) throws StackRefused {
    SortedSet<Integer> labels = new TreeSet<>();
    float last = 0;
    for (int k = 0; k < volume.slices(); k++) {
      ImageProcessor slice = volume.slice(k);
      for (int n = 0; n < slice.getPixelCount(); n++) {
        float value = slice.getf(n);
        if (value != last) {
          last = value;
          add(labels, value);
        }
      }
    }
    if (labels.isEmpty()) {
      throw new StackRefused("Every voxel is 0, the background: there is nothing to touch.");
    }
    return labels;
  }

  private static void add(SortedSet<Integer> labels, float value) throws StackRefused {
    if (value < 0 || value != (int) value) {
      throw new StackRefused(
          "The value "
              + value
              + " is no label: labels are whole numbers from 0. Use a threshold instead.");
    }
    if (value > 0) {
      labels.add((int) value);
    }
    if (labels.size() > MOST_LABELS) {
      throw new StackRefused(
          "There are more than "
              + MOST_LABELS
              + " values: these are grey values, no labels. Use a threshold instead.");
    }
  }
}
