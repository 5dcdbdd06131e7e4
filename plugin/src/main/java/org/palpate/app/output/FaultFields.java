package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.frame.FrameStatistics;

/** Lists the faults that frames met and handled, as fields of a report. */
public final class FaultFields {
  private FaultFields() {}

  /** Returns the fields of a rigid tool, which meets orientations too. */
  public static Map<String, Object> ofTool(FrameStatistics.Faults faults) {
    Map<String, Object> fields = of(faults);
    fields.put("bad_orientations", faults.badOrientations());
    return fields;
  }

  /** Returns the fields in the order of the report. */
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
