package org.palpate.device.jni;

import java.util.ArrayList;
import java.util.List;

/** Lines of key, tab, value, as the C++ side writes what it found. */
record KeyedLines(List<String> keys, List<String> values) {

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

  /** The value of the first line with that key; empty where there is none. */
  String first(String key) {
    int index = keys.indexOf(key);
    return index < 0 ? "" : values.get(index);
  }
}
