package org.palpate.device.jni;

import java.util.ArrayList;
import java.util.List;

/** Lines of key, tab and value, in which the C++ side writes its results. */
record KeyedLines(List<String> keys, List<String> values) {

  /** Parses the lines; a line without a tab is ignored. */
  static KeyedLines parse(String text) {
    List<String> keys = new ArrayList<>();
    List<String> values = new ArrayList<>();
    for (String line : text.split("\n", -1)) {
      int tab = line.indexOf('\t');
      if (tab >= 0) {
        keys.add(line.substring(0, tab));
        values.add(line.substring(tab + 1));
      }
    }
    return new KeyedLines(keys, values);
  }

  /** Returns the value of the first line with that key; empty if there is none. */
  String first(String key) {
    int index = keys.indexOf(key);
    return index < 0 ? "" : values.get(index);
  }
}
