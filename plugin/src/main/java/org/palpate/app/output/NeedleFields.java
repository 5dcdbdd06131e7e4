package org.palpate.app.output;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.host.ToolScene;

/** The fields of reports that say what a needle may enter, and what it entered. */
public final class NeedleFields {
  private NeedleFields() {}

  /** Adds the field {@code needle} to a report if the tool is a needle that may enter something. */
  public static void put(Report report, ToolScene scene) {
    scene
        .needle()
        .ifPresent(
            needle -> {
              Map<String, Object> field = new LinkedHashMap<>();
              field.put("penetrable", penetrable(scene));
              field.put("punctures", needle.punctures());
              field.put("deepest_mm", needle.deepestMm());
              report.put("needle", field);
            });
  }

  private static List<Map<String, Object>> penetrable(ToolScene scene) {
    List<Map<String, Object>> rows = new ArrayList<>();
    scene
        .contactScene()
        .tissues()
        .forEach(
            (name, tissue) -> {
              Map<String, Object> row = new LinkedHashMap<>();
              row.put("segment", name);
              row.put("puncture_n", tissue.punctureNewton());
              row.put("cutting_n", tissue.cuttingNewton());
              row.put("shaft_n_per_mm", tissue.shaftNewtonPerMm());
              rows.add(row);
            });
    return rows;
  }
}
