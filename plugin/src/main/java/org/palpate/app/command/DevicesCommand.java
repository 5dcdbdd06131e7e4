package org.palpate.app.command;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.device.jni.BackendProbe;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.device.jni.NativeDevice;
import org.palpate.io.table.ReportJson;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Tells what can be touched with here. */
@Command(
    name = "devices",
    description = "Tells which devices can be used here, and why not where one cannot.",
    footer = {
      "",
      "Examples:",
      "  palpate devices",
      "  palpate devices --json",
      "  palpate devices --watch hid:SN0001"
    })
public final class DevicesCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private OutputOptions output;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Option(
      names = "--watch",
      paramLabel = "NAME[:ID]",
      description = "Show one device live: position, buttons, rate; Enter draws a gentle force.")
  private String watched;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "How long to watch; until Ctrl-C without it.")
  private Double seconds;

  @Override
  public Integer call() throws IOException {
    checkOptionCombination();
    return watched == null ? list() : watch();
  }

  private void checkOptionCombination() {
    if (seconds != null && !(seconds > 0)) {
      throw PalpateException.wrongUse(
          "a positive number is needed", "--seconds " + seconds, "try --seconds 10");
    }
    if (seconds != null && watched == null) {
      throw PalpateException.wrongUse(
          "nothing is watched", "--seconds " + seconds, "add --watch NAME, or leave it out");
    }
    if (json && watched != null) {
      throw PalpateException.wrongUse(
          "what is live is not printed as JSON",
          "--json --watch " + watched,
          "take --report FILE.json with --watch");
    }
  }

  private int watch() throws IOException {
    int colon = watched.indexOf(':');
    String name = colon < 0 ? watched : watched.substring(0, colon);
    String id = colon < 0 ? "" : watched.substring(colon + 1);
    if (!DeviceCatalog.isNative(name)) {
      throw PalpateException.wrongUse(
          "there is no such device to watch",
          "--watch " + watched,
          "write hid, openhaptics, forcedimension or virtuose, with :ID where there are several");
    }
    Report report = new Report("devices", output.report(), List.of());
    try (NativeDevice device = DeviceCatalog.open(name, id)) {
      // Zero force goes first on Ctrl-C too.
      Runtime.getRuntime().addShutdownHook(new Thread(device::close, "palpate-device-end"));
      DeviceMonitor watch = new DeviceMonitor(device, System.in, spec.commandLine().getOut());
      String ending = watch.watch(seconds == null ? Double.POSITIVE_INFINITY : seconds);
      watch.putInto(report.put("device", watched).put("ending", ending));
      report.write();
      if (!ending.isEmpty()) {
        throw PalpateException.failed("the device went: " + watched + ": " + ending, null);
      }
      return 0;
    } catch (DeviceException e) {
      throw PalpateException.failed(e.getMessage(), e);
    }
  }

  private int list() throws IOException {
    Report report = new Report("devices", output.report(), List.of());
    List<BackendProbe> probeAll = DeviceCatalog.probeAll();
    report.put("backends", probeAll.stream().map(DevicesCommand::entry).toList());
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      ByteArrayOutputStream text = new ByteArrayOutputStream();
      ReportJson.write(report.fields(), text);
      out.print(text.toString(StandardCharsets.UTF_8));
      out.flush();
    } else {
      probeAll.forEach(finding -> print(finding, out));
    }
    report.write();
    return 0;
  }

  private static void print(BackendProbe finding, PrintWriter out) {
    String library = (finding.library() + " " + finding.version()).strip();
    line(out, finding.backend(), state(finding) + (library.isEmpty() ? "" : " (" + library + ")"));
    for (BackendProbe.Found device : finding.devices()) {
      String name = device.id().isEmpty() ? device.name() : device.id() + "  " + device.name();
      line(out, "", device.usable() ? name : name + ": " + device.why());
    }
  }

  /** Why not is said once: of the device where there is one, else of the back end. */
  private static String state(BackendProbe finding) {
    if (finding.usable()) {
      return "found";
    }
    boolean saidBelow = finding.devices().stream().anyMatch(d -> d.why().equals(finding.why()));
    return saidBelow ? "not usable yet" : "not usable: " + finding.why();
  }

  private static void line(PrintWriter out, String what, String text) {
    out.println(String.format(Locale.ROOT, "%-15s %s", what, text));
  }

  private static Map<String, Object> entry(BackendProbe finding) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", finding.backend());
    entry.put("usable", finding.usable());
    entry.put("why", finding.why());
    entry.put("library", finding.library());
    entry.put("library_version", finding.version());
    List<Object> devices = new ArrayList<>();
    for (BackendProbe.Found found : finding.devices()) {
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
