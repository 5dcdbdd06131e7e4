package org.palpate.app.output;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.palpate.app.process.VersionProvider;
import org.palpate.assess.ContactStatistics;
import org.palpate.assess.Hold;
import org.palpate.assess.SessionAssessor;
import org.palpate.assess.TremorSpectrum;

/** The values of an assessment under their keys. Immutable after it was made. */
final class AssessmentValues {
  /** The keys of a session's report that belong to an assessment. */
  static final List<String> OF_REPORT = List.of("protected", "carved", "added", "fracture");

  private static final List<String> SEGMENT_COLUMNS =
      List.of(
          "segment",
          "protected",
          "contacts",
          "seconds",
          "mean_force_n",
          "max_force_n",
          "max_force_s");

  private static final List<String> HOLD_COLUMNS =
      List.of("body", "from_s", "to_s", "moved_mm", "turned_deg");

  private final Map<String, Object> fields = new LinkedHashMap<>();
  private final List<Map<String, Object>> segments = new ArrayList<>();
  private final List<Map<String, Object>> holds = new ArrayList<>();

  /**
   * A table of the assessment.
   *
   * @param columns their keys
   * @param rows the values of each row by these keys
   */
  record Table(List<String> columns, List<Map<String, Object>> rows) {}

  /**
   * Gathers the values.
   *
   * @param objects the names of the objects in the scene
   * @param forbidden the indices of those that are protected
   * @param lost the number of frames that are missing
   * @param report the fields of the session's report
   */
  AssessmentValues(
      SessionAssessor assessor,
      List<String> objects,
      Set<Integer> forbidden,
      long lost,
      Map<String, Object> report) {
    fields.put("version", VersionProvider.version());
    fields.put("seconds", assessor.seconds());
    fields.put("frames", assessor.frames());
    fields.put("lost_frames", lost);
    fields.put("freed", assessor.freed());
    fields.put("hand_path_mm", assessor.handPathMm());
    fields.put("tool_path_mm", assessor.toolPathMm());
    fields.put("contact", contact(assessor));
    for (int n = 0; n < objects.size(); n++) {
      segments.add(segment(objects.get(n), forbidden.contains(n), assessor.contacts(n)));
    }
    fields.put("segments", segments);
    fields.put("tremor", tremor(assessor.tremor()));
    assessor.holds().forEach(hold -> holds.add(hold(objects.get(hold.body()), hold)));
    fields.put("holds", holds);
    for (String key : OF_REPORT) {
      if (report.containsKey(key)) {
        fields.put(key, report.get(key));
      }
    }
  }

  private static Map<String, Object> contact(SessionAssessor assessor) {
    Map<String, Object> field = new LinkedHashMap<>();
    putForces(assessor.contacts(), field);
    field.put("p95_force_n", assessor.exceededNewton(0.05));
    return field;
  }

  private static void putForces(ContactStatistics contacts, Map<String, Object> dest) {
    dest.put("contacts", contacts.contacts());
    dest.put("seconds", contacts.seconds());
    dest.put("mean_force_n", contacts.meanNewton());
    dest.put("max_force_n", contacts.largestNewton());
    dest.put("max_force_s", contacts.largestAtSeconds());
  }

  private static Map<String, Object> segment(
      String name, boolean isProtected, ContactStatistics contacts) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("segment", name);
    row.put("protected", isProtected ? 1L : 0L);
    putForces(contacts, row);
    return row;
  }

  private static Map<String, Object> tremor(TremorSpectrum tremor) {
    Map<String, Object> field = new LinkedHashMap<>();
    field.put("band_hz", List.of(TremorSpectrum.LOW_HERTZ, TremorSpectrum.HIGH_HERTZ));
    field.put("rms_mm", tremor.rmsMm().orElse(Double.NaN));
    field.put("peak_hz", tremor.peakHertz().orElse(Double.NaN));
    return field;
  }

  private static Map<String, Object> hold(String body, Hold hold) {
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("body", body);
    row.put("from_s", hold.fromSeconds());
    row.put("to_s", hold.toSeconds());
    row.put("moved_mm", hold.movedMm());
    row.put("turned_deg", Math.toDegrees(hold.turnedRad()));
    return row;
  }

  /** Adds whether a device or an option limits the forces. */
  void putLimited(boolean isLimited) {
    fields.put("force_limited", isLimited);
  }

  /** Returns the fields of the file of values, in order. */
  Map<String, Object> fields() {
    return fields;
  }

  /** Returns the table of segments. */
  Table segments() {
    return new Table(SEGMENT_COLUMNS, segments);
  }

  /** Returns the table of what the hand held. */
  Table holds() {
    return new Table(HOLD_COLUMNS, holds);
  }
}
