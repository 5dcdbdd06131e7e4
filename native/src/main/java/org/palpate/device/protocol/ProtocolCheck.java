package org.palpate.device.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.device.protocol.ReportDescriptor.Kind;

/** Checks a capture against every rule of the protocol that bytes can show. */
public final class ProtocolCheck {
  private static final int USAGE_PAGE = 0xFF00;
  private static final int USAGE = 0x50;

  private ProtocolCheck() {}

  /** Returns the result of each rule, in the order of the protocol's description. */
  public static List<CheckResult> run(HidCapture capture) {
    List<CheckResult> results = new ArrayList<>();
    checkDescriptor(capture, results);
    Capabilities capabilities = new Capabilities(capture.feature());
    capabilities.check(results);
    if (capabilities.isVersionOne()) {
      ReportRules reports = new ReportRules(capture, capabilities, results);
      reports.check();
      new ForceRules(capture, reports.reports(), capabilities, results).check();
    }
    return List.copyOf(results);
  }

  private static void checkDescriptor(HidCapture capture, List<CheckResult> results) {
    if (capture.descriptor().length() == 0) {
      results.add(
          CheckResult.note(
              false, "the report descriptor is that of the protocol", "the system gives none"));
      return;
    }
    ReportDescriptor found = ReportDescriptor.parse(capture.descriptor());
    results.add(
        CheckResult.of(
            found.usagePage() == USAGE_PAGE && found.usage() == USAGE,
            "the usage page is FF00 and the usage 50",
            String.format("%04X and %02X", found.usagePage(), found.usage())));
    checkReport(found, Kind.INPUT, InReport.ID, InReport.LENGTH, results);
    checkReport(found, Kind.OUTPUT, ForceRules.ID, ForceRules.LENGTH, results);
    checkReport(found, Kind.FEATURE, Capabilities.ID, Capabilities.LENGTH, results);
  }

  private static void checkReport(
      ReportDescriptor found, Kind kind, int id, int length, List<CheckResult> results) {
    int afterId = length - 1;
    results.add(
        CheckResult.of(
            found.bytes(kind, id) == afterId,
            "the descriptor states "
                + kind.name().toLowerCase(Locale.ROOT)
                + " report "
                + id
                + " with "
                + afterId
                + " bytes after the id",
            found.bytes(kind, id) + " bytes"));
  }
}
