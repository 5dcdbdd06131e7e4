package org.palpate.device.jni;

import java.util.ArrayList;
import java.util.List;

/**
 * The result of probing one back end on this machine.
 *
 * @param backend the name of the back end, as in {@code --device NAME}
 * @param usable whether a device could be opened through it now
 * @param library the file of the vendor's library; empty if none is needed or none was found
 * @param version the version of that library; empty if unknown
 * @param why the reason why it is not usable and the remedy, in one line; empty if it is usable
 * @param devices the devices that are connected now
 */
public record BackendProbe(
    String backend,
    boolean usable,
    String library,
    String version,
    String why,
    List<Found> devices) {

  /**
   * A device that a probe found.
   *
   * @param id the text to write after the back end's name and a colon; may be empty
   * @param name the name that a person knows
   * @param usable whether it could be opened now
   * @param why the reason why it is not usable and the remedy, in one line
   */
  public record Found(String id, String name, boolean usable, String why) {}

  /** Parses the lines that the C++ side writes. */
  static BackendProbe parse(String backend, String text) {
    KeyedLines lines = KeyedLines.parse(text);
    List<Found> devices = new ArrayList<>();
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
