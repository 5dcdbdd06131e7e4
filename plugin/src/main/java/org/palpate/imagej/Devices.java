package org.palpate.imagej;

import ij.text.TextWindow;
import java.util.List;
import org.palpate.device.jni.BackendProbe;
import org.palpate.device.jni.DeviceCatalog;

/** "Devices...": what can be used here, each back end found or why not. */
public final class Devices extends PalpateCommand {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 320;

  /** Made by ImageJ. */
  public Devices() {
    super("Devices");
  }

  @Override
  void execute() {
    StringBuilder rows = new StringBuilder();
    row(rows, "simulated", "found", "", "a hand that approaches, presses, slides, taps and tears");
    row(rows, "mouse", "found", "", "the mouse in the 3-D window");
    row(rows, "replay", "found", "FILE.csv", "a recorded trajectory");
    for (BackendProbe finding : realOnes()) {
      row(rows, finding.backend(), finding.usable() ? "found" : "not usable", "", finding.why());
      for (BackendProbe.Found device : finding.devices()) {
        row(
            rows,
            finding.backend(),
            device.usable() ? "device" : "not usable",
            device.id(),
            device.usable() ? device.name() : device.why());
      }
    }
    new TextWindow(
        "Palpate Devices", "Back end\tState\tId\tWhat", rows.toString().strip(), WIDTH, HEIGHT);
  }

  private static List<BackendProbe> realOnes() {
    return DeviceCatalog.probeAll().stream()
        .filter(finding -> DeviceCatalog.isNative(finding.backend()))
        .toList();
  }

  private static void row(StringBuilder rows, String... columns) {
    rows.append('\n').append(String.join("\t", columns));
  }
}
