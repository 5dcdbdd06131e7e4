package org.palpate.app.command;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.output.Report;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.device.jni.BackendProbe;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.device.jni.NativeDevice;
import org.palpate.io.table.ReportJson;
import org.palpate.opencl.OpenClCatalog;
import org.palpate.scene.window.GraphicsDriver;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists the devices that can be used on this machine, watches one, or checks one. */
@Command(
    name = "devices",
    description =
        "Lists the devices that can be used on this machine, and the reason if one cannot.",
    footer = {
      "",
      "Examples:",
      "  palpate devices",
      "  palpate devices --json",
      "  palpate devices --watch hid:SN0001",
      "  palpate devices --check hid --capture mine.hid",
      "  palpate devices --check capture:mine.hid"
    })
public final class DevicesCommand implements Callable<Integer> {
  private static final String MOUSE = "mouse";
  private static final String OPENCL = "opencl";

  @Spec private CommandSpec spec;
  @Mixin private OutputOptions output;

  @Option(names = "--json", description = "Prints the list as JSON.")
  private boolean json;

  @Option(
      names = "--watch",
      paramLabel = "NAME[:ID]",
      description =
          "Shows one device live: position, buttons and rate. Enter pushes the hand gently.")
  private String watched;

  @Option(
      names = "--check",
      paramLabel = "hid[:SERIAL]|capture:FILE",
      description =
          "Checks a hand-built device, or a capture of one, against the HID protocol. It sends no"
              + " force.")
  private String checked;

  @Option(
      names = "--capture",
      paramLabel = "FILE",
      description = "Writes what --check hid received, for a later check or a report of a fault.")
  private Path captureFile;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "Ends --watch after S seconds. Default: Ctrl-C ends it.")
  private Double seconds;

  @Override
  public Integer call() throws IOException {
    checkOptionCombination();
    return checked != null ? check() : watched == null ? list() : watch();
  }

  private int check() throws IOException {
    DeviceCheck check =
        new DeviceCheck(checked, Optional.ofNullable(captureFile), spec.commandLine().getOut());
    List<Path> inputs = check.inputs();
    Report report = new Report("devices", output.report(), inputs);
    if (captureFile != null) {
      OutputPaths.checked("--capture", captureFile, inputs);
    }
    return check.run(report);
  }

  private void checkOptionCombination() {
    NumberRange.seconds().checkGiven(seconds);
    if (seconds != null && watched == null) {
      throw PalpateException.wrongUse(
          "no device is watched", "--seconds " + seconds, "add --watch NAME, or leave it out");
    }
    if (json && watched != null) {
      throw PalpateException.wrongUse(
          "a live view cannot be printed as JSON",
          "--json --watch " + watched,
          "use --report FILE.json with --watch");
    }
    if (checked != null && (watched != null || json)) {
      throw PalpateException.wrongUse(
          "--check has its own output",
          "--check " + checked,
          "leave out " + (json ? "--json" : "--watch " + watched));
    }
    if (captureFile != null && checked == null) {
      throw DeviceCheck.noDevice(captureFile);
    }
  }

  private int watch() throws IOException {
    int colon = watched.indexOf(':');
    String name = colon < 0 ? watched : watched.substring(0, colon);
    String id = colon < 0 ? "" : watched.substring(colon + 1);
    if (!DeviceCatalog.isNative(name)) {
      throw PalpateException.wrongUse(
          "this device cannot be watched",
          "--watch " + watched,
          "write hid, openhaptics, forcedimension or virtuose, with :ID if there are several");
    }
    Report report = new Report("devices", output.report(), List.of());
    try (NativeDevice device = DeviceCatalog.open(name, id)) {
      // Closing sends zero force, also on Ctrl-C.
      Runtime.getRuntime().addShutdownHook(new Thread(device::close, "palpate-device-end"));
      DeviceMonitor watch = new DeviceMonitor(device, System.in, spec.commandLine().getOut());
      String ending = watch.watch(seconds == null ? Double.POSITIVE_INFINITY : seconds);
      watch.putInto(report.put("device", watched).put("ending", ending));
      report.write();
      if (!ending.isEmpty()) {
        throw PalpateException.failed("the device disconnected: " + watched + ": " + ending, null);
      }
      return 0;
    } catch (DeviceException e) {
      throw PalpateException.failed(e.getMessage(), e);
    }
  }

  /** Returns the results of all back ends; the mouse is the last of those without hardware. */
  private static List<BackendProbe> probes() {
    List<BackendProbe> probes = new ArrayList<>(DeviceCatalog.probeAll());
    int firstNative = 0;
    while (firstNative < probes.size()
        && !DeviceCatalog.isNative(probes.get(firstNative).backend())) {
      firstNative++;
    }
    probes.add(firstNative, mouse());
    probes.add(openCl());
    return probes;
  }

  private static BackendProbe mouse() {
    String why = GraphicsDriver.missingDisplay().orElse("");
    boolean usable = why.isEmpty();
    BackendProbe.Found found =
        new BackendProbe.Found("", "the mouse in the window: --device mouse", true, "");
    return new BackendProbe(MOUSE, usable, "", "", why, usable ? List.of(found) : List.of());
  }

  /** Returns the devices that can judge the legs of a tool. */
  private static BackendProbe openCl() {
    OpenClCatalog.Listing listing = OpenClCatalog.list();
    List<BackendProbe.Found> found =
        listing.devices().stream()
            .map(each -> new BackendProbe.Found("", each.name(), each.usable(), each.why()))
            .toList();
    String library = listing.devices().stream().findFirst().map(each -> each.platform()).orElse("");
    return new BackendProbe(OPENCL, listing.why().isEmpty(), library, "", listing.why(), found);
  }

  private int list() throws IOException {
    Report report = new Report("devices", output.report(), List.of());
    List<BackendProbe> probes = probes();
    report.put("backends", probes.stream().map(DevicesCommand::entry).toList());
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      ByteArrayOutputStream text = new ByteArrayOutputStream();
      ReportJson.write(report.fields(), text);
      out.print(text.toString(StandardCharsets.UTF_8));
      out.flush();
    } else {
      probes.forEach(probe -> print(probe, out));
    }
    report.write();
    return 0;
  }

  private static void print(BackendProbe probe, PrintWriter out) {
    String library = (probe.library() + " " + probe.version()).strip();
    line(out, probe.backend(), state(probe) + (library.isEmpty() ? "" : " (" + library + ")"));
    for (BackendProbe.Found device : probe.devices()) {
      String name = device.id().isEmpty() ? device.name() : device.id() + "  " + device.name();
      line(out, "", device.usable() ? name : name + ": " + device.why());
    }
  }

  /**
   * Returns the state of a back end. The reason is printed once: with the device if there is one,
   * otherwise with the back end.
   */
  private static String state(BackendProbe probe) {
    if (probe.usable()) {
      return "found";
    }
    boolean printedBelow = probe.devices().stream().anyMatch(d -> d.why().equals(probe.why()));
    return printedBelow ? "not usable yet" : "not usable: " + probe.why();
  }

  private static void line(PrintWriter out, String what, String text) {
    out.println(String.format(Locale.ROOT, "%-15s %s", what, text));
  }

  private static Map<String, Object> entry(BackendProbe probe) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", probe.backend());
    entry.put("usable", probe.usable());
    entry.put("why", probe.why());
    entry.put("library", probe.library());
    entry.put("library_version", probe.version());
    List<Object> devices = new ArrayList<>();
    for (BackendProbe.Found found : probe.devices()) {
      Map<String, Object> device = new LinkedHashMap<>();
      device.put("id", found.id());
      device.put("name", found.name());
      device.put("usable", found.usable());
      device.put("why", found.why());
      devices.add(device);
    }
    entry.put("devices", devices);
    return entry;
  }
}
