package org.palpate.app.output;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongToDoubleFunction;
import org.palpate.force.guide.NearestApproach;
import org.palpate.host.ContactScene;

/** The fields of reports that say how near the tool came to protected segments, and when. */
public final class ProtectedFields {
  private ProtectedFields() {}

  /**
   * Adds the field {@code protected} to a report if segments are protected.
   *
   * @param seconds returns the time of a frame, s
   */
  public static void put(Report report, ContactScene scene, LongToDoubleFunction seconds) {
    if (!scene.approaches().isEmpty()) {
      report.put("protected", of(scene.approaches(), seconds));
    }
  }

  private static List<Map<String, Object>> of(
      List<NearestApproach> approaches, LongToDoubleFunction seconds) {
    List<Map<String, Object>> fields = new ArrayList<>();
    for (NearestApproach approach : approaches) {
      Map<String, Object> field = new LinkedHashMap<>();
      field.put("segment", approach.segment());
      field.put("margin_mm", approach.marginMm());
      approach
          .nearestMm()
          .ifPresent(
              mm -> {
                field.put("nearest_mm", mm);
                field.put("nearest_frame", approach.frame());
                field.put("nearest_s", seconds.applyAsDouble(approach.frame()));
              });
      fields.add(field);
    }
    return fields;
  }
}
