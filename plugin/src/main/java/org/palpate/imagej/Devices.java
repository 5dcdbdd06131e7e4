package org.palpate.imagej;

import ij.text.TextWindow;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.Finding;

/** "Devices...": what can be used here, each back end found or why not. */
public final class Devices extends PalpateCommand {
  /** Made by ImageJ. */
  public Devices() {
    super("Devices");
  }

  @Override
  void execute() {
    StringBuilder rows = new StringBuilder("simulated\tfound\t\t\nreplay\tfound\t\t");
    for (Finding finding : DeviceCatalog.findings()) {
      row(rows, finding.backend(), finding.usable() ? "found" : "not usable", "", finding.why());
      for (Finding.Found device : finding.devices()) {
        row(
            rows,
            finding.backend(),
            device.usable() ? "device" : "not usable",
            device.id(),
            device.usable() ? device.name() : device.why());
      }
    }
    new TextWindow("Palpate Devices", "Back end\tState\tId\tWhat", rows.toString(), 720, 320);
  }

  private static void row(StringBuilder rows, String... columns) {
    rows.append('\n').append(String.join("\t", columns));
  }
}
