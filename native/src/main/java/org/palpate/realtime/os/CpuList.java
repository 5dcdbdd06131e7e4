package org.palpate.realtime.os;

import java.util.BitSet;
import java.util.stream.Collectors;

/** Reads and writes sets of processors in the kernel's notation, such as {@code 0-3,8}. */
final class CpuList {
  private CpuList() {}

  /**
   * Parses the kernel's notation; empty text gives an empty set.
   *
   * @throws IllegalArgumentException if the text is not a list of numbers and ranges
   */
  static BitSet parse(String text) {
    BitSet cpus = new BitSet();
    String trimmed = text.trim();
    if (trimmed.isEmpty() || trimmed.equals("(null)")) {
      return cpus;
    }
    for (String range : trimmed.split(",", -1)) {
      String[] ends = range.split("-", -1);
      if (ends.length > 2) {
        throw new IllegalArgumentException("not a list of processors: text=" + text);
      }
      int low = parseCpu(ends[0], text);
      cpus.set(low, parseCpu(ends[ends.length - 1], text) + 1);
    }
    return cpus;
  }

  private static int parseCpu(String number, String text) {
    try {
      return Integer.parseInt(number.trim());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("not a list of processors: text=" + text, e);
    }
  }

  /** Returns the set as text for a report; {@code none} if it is empty. */
  static String text(BitSet cpus) {
    return cpus.isEmpty() ? "none" : format(cpus);
  }

  /** Returns the number of every processor, such as {@code 0,1,2}. */
  static String format(BitSet cpus) {
    return cpus.stream().mapToObj(Integer::toString).collect(Collectors.joining(","));
  }
}
