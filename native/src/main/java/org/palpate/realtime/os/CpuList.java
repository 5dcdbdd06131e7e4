package org.palpate.realtime.os;

import java.util.BitSet;
import java.util.stream.Collectors;

/** Sets of processors in the kernel's notation, as in {@code 0-3,8}. */
final class CpuList {
  private CpuList() {}

  /**
   * Reads the kernel's notation; empty text is an empty set.
   *
   * @throws IllegalArgumentException where it is not a list of numbers and ranges
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

  /** The same for a person's eyes: {@code none} where there is none. */
  static String inWords(BitSet cpus) {
    return cpus.isEmpty() ? "none" : format(cpus);
  }

  /** Writes every processor by its number, as in {@code 0,1,2}. */
  static String format(BitSet cpus) {
    return cpus.stream().mapToObj(Integer::toString).collect(Collectors.joining(","));
  }
}
