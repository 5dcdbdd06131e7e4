package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

class DeviceCheckTest {
  @TempDir private Path folder;

  private final StringWriter said = new StringWriter();

  private DeviceCheck check(String checked, Optional<Path> capture) {
    return new DeviceCheck(checked, capture, new PrintWriter(said));
  }

  private static void refuses(String line, org.junit.jupiter.api.function.Executable call) {
    PalpateException refusal = assertThrows(PalpateException.class, call);
    assertEquals(line, refusal.getMessage());
    assertEquals(PalpateException.WRONG_USE, refusal.exitCode());
  }

  @ParameterizedTest
  @ValueSource(strings = {"simulated", "mouse", "capture", "capture:", "", "virtuose:host"})
  void onlyHidDevicesAndCapturesAreChecked(String checked) {
    String shown = checked.equals("capture:") ? "capture" : checked;
    refuses(
        "this device cannot be checked: --check "
            + shown
            + ": write hid, hid:SERIAL or capture:FILE",
        () -> check(checked, Optional.empty()));
  }

  @Test
  void aCaptureIsAnInputAndIsNotCaptured() {
    assertEquals(List.of(Path.of("a.hid")), check("capture:a.hid", Optional.empty()).inputs());
    assertEquals(List.of(), check("hid:7", Optional.of(Path.of("b.hid"))).inputs());
    refuses(
        "no device is captured: --capture b.hid: add --check hid, or leave it out",
        () -> check("capture:a.hid", Optional.of(Path.of("b.hid"))));
  }

  private void run(Path file) throws IOException {
    check("capture:" + file, Optional.empty())
        .run(new Report("devices", Optional.empty(), List.of()));
  }

  @Test
  void aCaptureThatCannotBeReadIsRefused() throws IOException {
    Path none = folder.resolve("none.hid");
    refuses("there is no such file: " + none + ": check the name", () -> run(none));
    Path binary = Files.write(folder.resolve("binary.hid"), new byte[] {-1, -2, -3});
    refuses(
        "the capture cannot be read: capture:"
            + binary
            + ": it is not text: capture the device again",
        () -> run(binary));
    Path other = Files.writeString(folder.resolve("other.hid"), "hello\n");
    PalpateException refusal = assertThrows(PalpateException.class, () -> run(other));
    assertTrue(
        refusal.getMessage().startsWith("the capture cannot be read: capture:" + other + ": "),
        refusal.getMessage());
  }

  @Test
  void optionsOfAWindowNeedOne() {
    CommandLine command =
        new CommandLine(new TouchCommand()).setCaseInsensitiveEnumValuesAllowed(true);
    for (String option : List.of("--slices=middle", "--surface=bits", "--upside-down")) {
      ParseResult given = command.parseArgs(option);
      new WindowNeeds(false).check(given);
      String name = option.split("=", 2)[0];
      refuses(
          name + " needs a window: --headless: leave one of them out",
          () -> new WindowNeeds(true).check(given));
    }
    new WindowNeeds(true).check(command.parseArgs("--solver=smooth"));
    new WindowNeeds(true).check("--device mouse", false);
    refuses(
        "--device mouse needs a window: --headless: leave one of them out",
        () -> new WindowNeeds(true).check("--device mouse", true));
  }
}
