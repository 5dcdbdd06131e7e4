package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.device.protocol.CaptureFormatException;
import org.palpate.device.protocol.CheckResult;
import org.palpate.device.protocol.HidCapture;
import org.palpate.device.protocol.ProtocolCheck;
import org.palpate.host.DeviceName;
import org.palpate.io.file.AtomicFile;

/** Checks a hand-built device, or a capture of one, against the HID protocol. */
final class DeviceCheck {
  private static final String HID = "hid";
  private static final String CAPTURE = "capture";

  private final DeviceName checked;
  private final Optional<Path> captureFile;
  private final PrintWriter out;

  /**
   * Creates a check.
   *
   * @param checked {@code hid[:SERIAL]} or {@code capture:FILE}
   * @param captureFile receives a capture of the device, for a later check
   * @throws PalpateException exit code 2, if neither can be checked or a capture would be copied
   */
  DeviceCheck(String checked, Optional<Path> captureFile, PrintWriter out) {
    this.checked = DeviceName.parse(checked);
    this.captureFile = captureFile;
    this.out = out;
    requireKnown();
  }

  /** Returns the file that is checked; empty if a device is. */
  List<Path> inputs() {
    return isDevice() ? List.of() : List.of(Path.of(checked.id()));
  }

  /**
   * Prints a line for each rule, and writes the report.
   *
   * @return 0 if no rule is broken, otherwise 1
   */
  int run(Report report) throws IOException {
    List<String> lines = isDevice() ? capture() : readLines(Path.of(checked.id()));
    HidCapture capture = parse(lines);
    if (captureFile.isPresent()) {
      save(captureFile.get(), lines);
    }
    List<CheckResult> results = ProtocolCheck.run(capture);
    results.forEach(this::print);
    long failed = results.stream().filter(r -> r.outcome() == CheckResult.Outcome.FAILED).count();
    out.println(failed == 0 ? "no rule is broken" : failed + " of " + results.size() + " failed");
    report.put("device", checked.toString()).put("failed", failed);
    report.put("checks", results.stream().map(DeviceCheck::entry).toList());
    report.write();
    return failed == 0 ? 0 : PalpateException.FAILED;
  }

  private void requireKnown() {
    boolean isCapture = checked.name().equals(CAPTURE) && !checked.id().isEmpty();
    if (!isDevice() && !isCapture) {
      throw PalpateException.wrongUse(
          "this device cannot be checked",
          "--check " + checked,
          "write hid, hid:SERIAL or capture:FILE");
    }
    if (isCapture && captureFile.isPresent()) {
      throw noDevice(captureFile.get());
    }
  }

  /** Returns the error for {@code --capture} if no device is checked. */
  static PalpateException noDevice(Path captureFile) {
    return PalpateException.wrongUse(
        "no device is captured", "--capture " + captureFile, "add --check hid, or leave it out");
  }

  private boolean isDevice() {
    return checked.name().equals(HID);
  }

  private List<String> capture() {
    try {
      return DeviceCatalog.capture(HID, checked.id());
    } catch (DeviceException e) {
      throw PalpateException.failed(e.getMessage(), e);
    }
  }

  private List<String> readLines(Path file) throws IOException {
    try {
      return Files.readAllLines(file, StandardCharsets.US_ASCII);
    } catch (NoSuchFileException e) {
      throw PalpateException.wrongUse("there is no such file", file.toString(), "check the name");
    } catch (CharacterCodingException e) {
      throw wrongCapture("it is not text: capture the device again");
    }
  }

  private HidCapture parse(List<String> lines) {
    try {
      return HidCapture.parse(lines);
    } catch (CaptureFormatException e) {
      throw wrongCapture(e.getMessage());
    }
  }

  private PalpateException wrongCapture(String why) {
    return PalpateException.wrongUse("the capture cannot be read", checked.toString(), why);
  }

  private void save(Path file, List<String> lines) throws IOException {
    List<String> all = new ArrayList<>(List.of("# palpate devices --check " + checked));
    all.addAll(lines);
    AtomicFile.write(file, String.join("\n", all) + "\n");
  }

  private void print(CheckResult result) {
    out.println(
        String.format(
            Locale.ROOT, "%-6s  %s: %s", result.outcome(), result.rule(), result.found()));
  }

  private static Map<String, Object> entry(CheckResult result) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("rule", result.rule());
    entry.put("outcome", result.outcome().toString());
    entry.put("found", result.found());
    return entry;
  }
}
