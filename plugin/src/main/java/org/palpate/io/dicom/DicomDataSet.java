package org.palpate.io.dicom;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.io.file.NumberParser;

/** The attributes of a DICOM file or of a sequence item, limited to those of {@link DicomTag}. */
final class DicomDataSet {
  private final Map<Integer, String> texts = new HashMap<>();
  private final Map<Integer, int[]> numbers = new HashMap<>();
  private final Map<Integer, List<DicomDataSet>> sequences = new HashMap<>();

  /** Stores a text attribute without its padding. */
  void put(int tag, byte[] text) {
    String value = new String(text, StandardCharsets.ISO_8859_1);
    int end = value.length();
    while (end > 0 && (value.charAt(end - 1) == 0 || value.charAt(end - 1) == ' ')) {
      end--;
    }
    texts.put(tag, value.substring(0, end).stripLeading());
  }

  /** Stores a numeric attribute of one or several numbers; ignores an empty one. */
  void put(int tag, int... values) {
    if (values.length > 0) {
      numbers.put(tag, values.clone());
    }
  }

  /** Appends a new item to a sequence and returns it. */
  DicomDataSet addItem(int tag) {
    DicomDataSet item = new DicomDataSet();
    sequences.computeIfAbsent(tag, unused -> new ArrayList<>()).add(item);
    return item;
  }

  /** Returns the items of a sequence; empty if it is absent. */
  List<DicomDataSet> items(int tag) {
    return sequences.getOrDefault(tag, List.of());
  }

  /** Returns the text of an attribute; empty if it is absent. */
  String text(int tag) {
    return texts.getOrDefault(tag, "");
  }

  /** Returns the first number of an attribute, or the fallback if it is absent. */
  int number(int tag, int fallback) {
    int[] found = numbers.get(tag);
    return found == null ? fallback : found[0];
  }

  /** Returns all numbers of an attribute; empty if it is absent. */
  int[] numbers(int tag) {
    int[] found = numbers.get(tag);
    return found == null ? new int[0] : found.clone();
  }

  /**
   * Returns all decimals of an attribute; empty if it is absent. A word that is no number gives
   * NaN.
   */
  double[] decimals(int tag) {
    String text = text(tag);
    if (text.isEmpty()) {
      return new double[0];
    }
    return Arrays.stream(text.split("\\\\", -1)).mapToDouble(NumberParser::number).toArray();
  }

  /**
   * Returns exactly {@code count} decimals, or null if the attribute is absent or empty. A word
   * that is no number, or another count, gives NaN.
   */
  double[] decimals(int tag, int count) {
    double[] decimals = decimals(tag);
    if (decimals.length == 0) {
      return null;
    }
    if (decimals.length != count) {
      decimals = new double[count];
      Arrays.fill(decimals, Double.NaN);
    }
    return decimals;
  }
}
