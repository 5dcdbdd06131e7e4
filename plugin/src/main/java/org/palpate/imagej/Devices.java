package org.palpate.imagej;

import ij.text.TextWindow;
import java.util.List;
import org.palpate.device.jni.BackendProbe;
import org.palpate.device.jni.DeviceCatalog;

/** "Devices...": lists the back ends and devices that can be used, and the reason if one cannot. */
public final class Devices extends PalpateCommand {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 320;

  /** Creates the command; ImageJ calls this. */
  public Devices() {
    super("Devices");
  }

  @Override
  void execute() {
    StringBuilder rows = new StringBuilder();
    row(rows, "simulated", "found", "", "a hand that approaches, presses, slides, taps and tears");
    row(rows, "mouse", "found", "", "the mouse in the 3-D window");
    row(rows, "replay", "found", "FILE.csv", "a recorded trajectory");
    for (BackendProbe probe : nativeBackends()) {
      row(rows, probe.backend(), probe.usable() ? "found" : "not usable", "", probe.why());
      for (BackendProbe.Found device : probe.devices()) {
        row(
            rows,
            probe.backend(),
            device.usable() ? "device" : "not usable",
            device.id(),
            device.usable() ? device.name() : device.why());
      }
    }
    new TextWindow(
        "Palpate Devices", "Back end\tState\tId\tWhat", rows.toString().strip(), WIDTH, HEIGHT);
  }

  private static List<BackendProbe> nativeBackends() {
    return DeviceCatalog.probeAll().stream()
        .filter(probe -> DeviceCatalog.isNative(probe.backend()))
        .toList();
  }

  private static void row(StringBuilder rows, String... columns) {
    rows.append('\n').append(String.join("\t", columns));
  }
}
