package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.statistics.WorkPercentiles;

/** The fields of a report that state the work of frames. */
public final class WorkFields {
  private WorkFields() {}

  /** Returns the fields in the order of the report. */
  public static Map<String, Object> of(WorkPercentiles work) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("p50", work.p50());
    fields.put("p99", work.p99());
    fields.put("p99_9", work.p999());
    fields.put("max", work.max());
    return fields;
  }
}
