package org.palpate.io.nrrd;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;

/** Parses the segments that 3D Slicer describes in the key/value pairs of a {@code .seg.nrrd}. */
final class SlicerLabels {
  private static final int MAX_SEGMENTS = 100_000;

  private SlicerLabels() {}

  /**
   * Returns the label table, if the header has one; segments that are not understood are left out.
   */
  static Optional<LabelTable> of(NrrdHeader header) {
    Map<Long, Label> labels = new TreeMap<>();
    Map<String, String> pairs = header.keyValues();
    for (int n = 0; n < MAX_SEGMENTS && pairs.containsKey("Segment" + n + "_ID"); n++) {
      String prefix = "Segment" + n + "_";
      int value = NumberParser.positiveInt(pairs.getOrDefault(prefix + "LabelValue", ""));
      if (value > 0) {
        String name = pairs.getOrDefault(prefix + "Name", "segment " + value);
        labels.put((long) value, new Label(name, rgb(pairs.getOrDefault(prefix + "Color", ""))));
      }
    }
    return labels.isEmpty() ? Optional.empty() : Optional.of(new LabelTable(labels));
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
