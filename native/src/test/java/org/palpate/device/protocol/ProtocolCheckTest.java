package org.palpate.device.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.protocol.CheckResult.Outcome;

class ProtocolCheckTest {

  @ParameterizedTest
  @ValueSource(strings = {"six-degrees", "three-degrees"})
  void theExampleFirmwareKeepsEveryRule(String name) throws Exception {
    List<CheckResult> results = ProtocolCheck.run(example(name));
    assertTrue(results.size() > 25, results.toString());
    assertEquals(List.of(), broken(results));
  }

  /** The host's side in C++ is tested against the same firmware. */
  @Test
  void theNumbersOfTheProtocolAreThoseOfTheExampleFirmware() throws IOException {
    String header = Files.readString(docs().resolve("firmware").resolve("palpate_device.h"));
    Map<String, Integer> numbers = new LinkedHashMap<>();
    numbers.put("IN_BYTES = ", InReport.LENGTH);
    numbers.put("OUT_BYTES = ", ForceRules.LENGTH);
    numbers.put("CAPABILITIES_BYTES = ", Capabilities.LENGTH);
    numbers.put("IN_ID = ", InReport.ID);
    numbers.put("OUT_ID = ", ForceRules.ID);
    numbers.put("CAPABILITIES_ID = ", Capabilities.ID);
    numbers.put("VERSION = ", Capabilities.VERSION);
    numbers.put("HAND_PRESENT = 1 << ", Integer.numberOfTrailingZeros(InReport.HAND_PRESENT));
    numbers.put("FORCE_ON = 1 << ", Integer.numberOfTrailingZeros(InReport.FORCE_ON));
    numbers.put("WATCHDOG_ZEROED = 1 << ", Integer.numberOfTrailingZeros(InReport.WATCHDOG_ZEROED));
    numbers.put(
        "HAS_HAND_SENSOR = 1 << ", Integer.numberOfTrailingZeros(Capabilities.HAS_HAND_SENSOR));
    numbers.forEach(
        (name, value) -> {
          String line = "  PALPATE_" + name + value + ",";
          assertTrue(header.contains(line), "the firmware does not have " + line);
        });
  }

  @Test
  void aFirmwareWithoutAWatchdogIsFound() throws Exception {
    List<String> broken = broken(ProtocolCheck.run(example("no-watchdog")));
    assertEquals(1, broken.size(), broken.toString());
    assertTrue(broken.get(0).startsWith("the watchdog trips in its time"), broken.toString());
  }

  @Test
  void eachFaultInAReportBreaksItsOwnRule() throws Exception {
    assertReportFault("the first byte", bytes -> bytes[0] = 7);
    assertReportFault("the sequence rises", bytes -> bytes[2] = (byte) (bytes[2] - 3));
    assertReportFault("reserved bits of the state", bytes -> bytes[1] |= (byte) 0x80);
    assertReportFault("the quaternion", bytes -> bytes[27] = 0x20);
    assertReportFault("the position is in um", bytes -> bytes[10] = 0x10);
    assertReportFault("only buttons", bytes -> bytes[34] = 4);
    assertReportFault("no fault", bytes -> bytes[40] = 1);
    assertReportFault("without a hand sensor", bytes -> bytes[1] &= (byte) ~InReport.HAND_PRESENT);
    assertReportFault("the force is off", bytes -> bytes[1] |= (byte) InReport.FORCE_ON);
    assertReportFault("echoed time", bytes -> bytes[44] = (byte) (bytes[44] + 1));
  }

  @Test
  void eachFaultInTheCapabilitiesBreaksItsOwnRule() throws Exception {
    assertFeatureFault("feature report 3 has", bytes -> bytes[3] = 'X');
    assertFeatureFault("the version is 1", bytes -> bytes[1] = 2);
    assertFeatureFault("the lasting force", bytes -> bytes[9] = 0x7F);
    assertFeatureFault("a device with force", bytes -> Arrays.fill(bytes, 10, 12, (byte) 0));
    assertFeatureFault("reserved bytes", bytes -> bytes[30] = 1);
    assertFeatureFault("3 to 7 degrees", bytes -> bytes[21] = 2);
  }

  @Test
  void aDeviceWithoutAnOrientationSendsZeros() throws Exception {
    HidCapture three = example("three-degrees");
    Consumer<byte[]> zero = bytes -> Arrays.fill(bytes, 20, 28, (byte) 0);
    assertEquals(List.of(), broken(ProtocolCheck.run(withReports(three, zero, 0))));
    HidCapture six = example("six-degrees");
    assertEquals(1, broken(ProtocolCheck.run(withReports(six, zero, 0))).size());
  }

  @Test
  void aDescriptorWithAnotherLengthIsFound() throws Exception {
    HidCapture good = example("six-degrees");
    byte[] descriptor = good.descriptor().toArray();
    assertEquals(0x2F, descriptor[19]);
    descriptor[19] = 46;
    HidCapture bad = new HidCapture("", Bytes.of(descriptor), good.feature(), good.reports());
    assertEquals(
        List.of("the descriptor states input report 1 with 47 bytes after the id"),
        broken(ProtocolCheck.run(bad)));
  }

  @Test
  void noBytesWhateverTheyAreBreakTheCheck() throws Exception {
    HidCapture good = example("six-degrees");
    for (int length = 0; length <= 64; length++) {
      byte[] filled = new byte[length];
      Arrays.fill(filled, (byte) (37 * length));
      Bytes bytes = Bytes.of(filled);
      List<HidCapture.Report> reports = List.of(new HidCapture.Report(true, 0, bytes));
      ProtocolCheck.run(new HidCapture("", bytes, bytes, reports));
      ProtocolCheck.run(new HidCapture("", bytes, good.feature(), reports));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "in 5", "in five 01", "in 5 0g", "out 5 012", "out 5 0200", "inn 5 01"})
  void aLineThatIsNoneOfACaptureIsNamed(String line) {
    CaptureFormatException e =
        assertThrows(CaptureFormatException.class, () -> HidCapture.parse(List.of("#", line)));
    assertTrue(e.getMessage().startsWith("line 2: "), e.getMessage());
  }

  /** Checks that a change of one report in the middle breaks one rule alone. */
  private static void assertReportFault(String rule, Consumer<byte[]> fault) throws Exception {
    HidCapture good = example("six-degrees");
    assertBreaks(rule, withReports(good, fault, good.reports().size() / 2));
  }

  private static void assertFeatureFault(String rule, Consumer<byte[]> fault) throws Exception {
    HidCapture good = example("six-degrees");
    byte[] feature = good.feature().toArray();
    fault.accept(feature);
    assertBreaks(rule, new HidCapture("", good.descriptor(), Bytes.of(feature), good.reports()));
  }

  private static void assertBreaks(String rule, HidCapture capture) {
    List<String> broken = broken(ProtocolCheck.run(capture));
    assertEquals(1, broken.size(), rule + " expected: " + broken);
    assertTrue(broken.get(0).startsWith(rule), rule + " expected: " + broken);
  }

  /** Changes the first report of the device from a number on; all of them from 0. */
  private static HidCapture withReports(HidCapture capture, Consumer<byte[]> fault, int from) {
    List<HidCapture.Report> reports = new ArrayList<>();
    boolean changed = false;
    for (HidCapture.Report report : capture.reports()) {
      byte[] bytes = report.bytes().toArray();
      boolean changes = report.fromDevice() && reports.size() >= from && (from == 0 || !changed);
      if (changes) {
        fault.accept(bytes);
        changed = true;
      }
      reports.add(new HidCapture.Report(report.fromDevice(), report.micros(), Bytes.of(bytes)));
    }
    return new HidCapture("", capture.descriptor(), capture.feature(), reports);
  }

  private static List<String> broken(List<CheckResult> results) {
    return results.stream()
        .filter(result -> result.outcome() == Outcome.FAILED)
        .map(CheckResult::rule)
        .toList();
  }

  private static HidCapture example(String name) throws IOException, CaptureFormatException {
    return HidCapture.parse(Files.readAllLines(docs().resolve("captures").resolve(name + ".hid")));
  }

  private static Path docs() {
    Path here = Path.of("docs", "captures");
    return Files.isDirectory(here) ? here.getParent() : Path.of("native", "docs");
  }
}
