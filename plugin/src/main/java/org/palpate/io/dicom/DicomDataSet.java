package org.palpate.io.dicom;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.io.file.NumberParser;

/** Attributes of a DICOM file, or of an item of a sequence: those of {@link DicomTag} alone. */
final class DicomDataSet {
  private final Map<Integer, String> texts = new HashMap<>();
  private final Map<Integer, Integer> numbers = new HashMap<>();
  private final Map<Integer, List<DicomDataSet>> sequences = new HashMap<>();

  void put(int tag, byte[] text) {
    String value = new String(text, StandardCharsets.ISO_8859_1);
    int end = value.length();
    while (end > 0 && (value.charAt(end - 1) == 0 || value.charAt(end - 1) == ' ')) {
      end--;
    }
    texts.put(tag, value.substring(0, end).stripLeading());
  }

  void put(int tag, int number) {
    numbers.put(tag, number);
  }

  /** A new item at the end of a sequence. */
  DicomDataSet addItem(int tag) {
    DicomDataSet item = new DicomDataSet();
    sequences.computeIfAbsent(tag, unused -> new ArrayList<>()).add(item);
    return item;
  }

  /** The items of a sequence, none where it is absent. */
  List<DicomDataSet> items(int tag) {
    return sequences.getOrDefault(tag, List.of());
  }

  /** The text of an attribute, empty where it is absent. */
  String text(int tag) {
    return texts.getOrDefault(tag, "");
  }

  /** The number of an attribute, or the fallback where it is absent. */
  int number(int tag, int fallback) {
    return numbers.getOrDefault(tag, fallback);
  }

  /**
   * So many decimals, or null where the attribute is absent or empty; NaN where one is no number.
   */
  double[] decimals(int tag, int count) {
    String text = text(tag);
    if (text.isEmpty()) {
      return null;
    }
    String[] words = text.split("\\\\", -1);
    double[] decimals = new double[count];
    for (int n = 0; n < count; n++) {
      decimals[n] = words.length == count ? NumberParser.number(words[n]) : Double.NaN;
    }
    return decimals;
  }
}
