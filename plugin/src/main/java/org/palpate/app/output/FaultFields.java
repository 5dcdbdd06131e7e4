package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.frame.FrameStatistics;

/** What went wrong in frames and was met, as a report has it. */
public final class FaultFields {
  private FaultFields() {}

  public static Map<String, Object> of(FrameStatistics.Faults faults) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("held", faults.held());
    fields.put("not_finite", faults.notFinite());
    fields.put("bad_times", faults.badTimes());
    fields.put("silences", faults.silences());
    fields.put("clock_jumps", faults.clockJumps());
    fields.put("force_not_finite", faults.forceNotFinite());
    fields.put("unreached", faults.unreached());
    return fields;
  }
}
