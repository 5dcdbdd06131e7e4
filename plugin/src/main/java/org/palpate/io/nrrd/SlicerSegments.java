package org.palpate.io.nrrd;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;

/**
 * The segments that 3D Slicer describes in the key/value pairs of a {@code .seg.nrrd}, in the order
 * of the file.
 *
 * @param segments those that have a positive label value; others are left out
 */
record SlicerSegments(List<Segment> segments) {
  private static final int MAX_SEGMENTS = 100_000;

  /**
   * A segment: the voxels of one label in one layer.
   *
   * @param layer the layer, from 0; segments of different layers may overlap
   * @param value the label
   * @param label name and colour
   */
  record Segment(int layer, int value, Label label) {}

  /** Parses the pairs of a header. */
  static SlicerSegments of(NrrdHeader header) {
    List<Segment> segments = new ArrayList<>();
    Map<String, String> pairs = header.keyValues();
    for (int n = 0; n < MAX_SEGMENTS && pairs.containsKey("Segment" + n + "_ID"); n++) {
      String prefix = "Segment" + n + "_";
      int value = NumberParser.positiveInt(pairs.getOrDefault(prefix + "LabelValue", ""));
      if (value > 0) {
        String name = pairs.getOrDefault(prefix + "Name", "segment " + value);
        Label label = new Label(name, rgb(pairs.getOrDefault(prefix + "Color", "")));
        int layer = NumberParser.positiveInt(pairs.getOrDefault(prefix + "Layer", "0"));
        segments.add(new Segment(layer, value, label));
      }
    }
    return new SlicerSegments(segments);
  }

  /** Returns names and colours by the labels of one layer; empty if the layer has no segment. */
  Optional<LabelTable> table(int layer) {
    Map<Long, Label> labels = new TreeMap<>();
    for (Segment segment : segments) {
      if (segment.layer() == layer) {
        labels.put((long) segment.value(), segment.label());
      }
    }
    return labels.isEmpty() ? Optional.empty() : Optional.of(new LabelTable(labels, true));
  }

  /** Returns names and colours by the number of the segment, from 1, whatever its layer. */
  LabelTable numbered() {
    Map<Long, Label> labels = new TreeMap<>();
    for (Segment segment : segments) {
      labels.put(labels.size() + 1L, segment.label());
    }
    return new LabelTable(labels, true);
  }

  /** Returns the number of each segment of a layer, from 1, by its label. */
  Map<Integer, Integer> numbers(int layer) {
    Map<Integer, Integer> numbers = new TreeMap<>();
    for (int n = 0; n < segments.size(); n++) {
      if (segments.get(n).layer() == layer) {
        numbers.put(segments.get(n).value(), n + 1);
      }
    }
    return numbers;
  }

  /** Parses three numbers from 0 to 1; white if they are not that. */
  private static int rgb(String color) {
    String[] words = color.strip().split("\\s+", -1);
    int rgb = 0;
    for (int channel = 0; channel < 3; channel++) {
      double part = words.length == 3 ? NumberParser.number(words[channel]) : 1;
      rgb = rgb << 8 | (part >= 0 && part <= 1 ? (int) Math.round(part * 255) : 255);
    }
    return rgb;
  }
}
