package org.palpate.device.protocol;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * Bytes that a device and its host exchanged, as lines of text. Immutable.
 *
 * <pre>
 *   # a comment
 *   name Fake haptic device
 *   descriptor 0600ff0950...
 *   feature 0301504c5054...
 *   in 1042 0103...
 *   out 100031 0200...
 * </pre>
 *
 * <p>The number after {@code in} and {@code out} is the host's time since the start, us.
 *
 * @param name the device's name; may be empty
 * @param descriptor the report descriptor; empty if the system does not give it
 * @param feature feature report 3; empty if the device did not answer
 * @param reports all reports in the order of the host's time
 */
public record HidCapture(String name, Bytes descriptor, Bytes feature, List<Report> reports) {

  /**
   * One report.
   *
   * @param fromDevice whether the device sent it
   * @param micros the host's time since the start of the capture, us
   * @param bytes all bytes, the report id first
   */
  public record Report(boolean fromDevice, long micros, Bytes bytes) {}

  /**
   * Parses the lines of a capture.
   *
   * @throws CaptureFormatException if a line is not one of a capture, or there is no report
   */
  public static HidCapture parse(List<String> lines) throws CaptureFormatException {
    String name = "";
    Bytes descriptor = Bytes.of();
    Bytes feature = Bytes.of();
    List<Report> reports = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      String[] words = lines.get(i).strip().split("\\s+", 2);
      String rest = words.length > 1 ? words[1] : "";
      switch (words[0]) {
        case "name" -> name = rest;
        case "descriptor" -> descriptor = bytes(rest, i + 1);
        case "feature" -> feature = bytes(rest, i + 1);
        case "in", "out" -> reports.add(report(words[0].equals("in"), rest, i + 1));
        default -> checkComment(words[0], i + 1);
      }
    }
    if (reports.isEmpty()) {
      throw new CaptureFormatException(lines.size(), "there is no report");
    }
    return new HidCapture(name, descriptor, feature, List.copyOf(reports));
  }

  private static void checkComment(String word, int line) throws CaptureFormatException {
    if (!word.isEmpty() && !word.startsWith("#")) {
      throw new CaptureFormatException(line, "a line cannot begin with " + word);
    }
  }

  private static Report report(boolean fromDevice, String rest, int line)
      throws CaptureFormatException {
    String[] words = rest.split("\\s+", -1);
    if (words.length != 2) {
      throw new CaptureFormatException(line, "a report needs a time and its bytes");
    }
    if (!words[0].matches("[0-9]{1,18}")) {
      throw new CaptureFormatException(line, "the time is not a number");
    }
    Bytes bytes = bytes(words[1], line);
    if (!fromDevice && bytes.length() != ForceRules.LENGTH) {
      throw new CaptureFormatException(line, "report 2 has " + ForceRules.LENGTH + " bytes");
    }
    return new Report(fromDevice, Long.parseLong(words[0]), bytes);
  }

  private static Bytes bytes(String hex, int line) throws CaptureFormatException {
    try {
      return Bytes.of(HexFormat.of().parseHex(hex));
    } catch (IllegalArgumentException e) {
      throw new CaptureFormatException(line, "the bytes are not hexadecimal");
    }
  }
}
