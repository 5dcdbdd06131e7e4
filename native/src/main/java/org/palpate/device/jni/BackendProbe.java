package org.palpate.device.jni;

import java.util.List;

/**
 * What one back end found on this machine.
 *
 * @param backend its name, as in {@code --device NAME}
 * @param usable whether a device could be opened through it now
 * @param library the file of the vendor's library; empty where none is needed or none was found
 * @param version of that library; empty where it does not say
 * @param why one line: why it is not usable and what to do; empty where it is
 * @param devices seen now
 */
public record BackendProbe(
    String backend,
    boolean usable,
    String library,
    String version,
    String why,
    List<Found> devices) {

  /**
   * One device.
   *
   * @param id to write after the back end's name and a colon; may be empty
   * @param name as a person knows it
   * @param usable whether it could be opened now
   * @param why one line: why not and what to do
   */
  public record Found(String id, String name, boolean usable, String why) {}

  static BackendProbe parse(String backend, String text) {
    KeyedLines lines = KeyedLines.parse(text);
    List<Found> devices = new java.util.ArrayList<>();
    for (int i = 0; i + 3 < lines.keys().size(); i++) {
      if (lines.keys().get(i).equals("device")) {
        List<String> v = lines.values().subList(i, i + 4);
        devices.add(new Found(v.get(0), v.get(1), v.get(2).equals("1"), v.get(3)));
      }
    }
    return new BackendProbe(
        backend,
        lines.first("usable").equals("1"),
        lines.first("library"),
        lines.first("version"),
        lines.first("why"),
        List.copyOf(devices));
  }
}
