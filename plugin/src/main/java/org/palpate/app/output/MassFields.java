package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.force.MassiveContact;
import org.palpate.host.ToolScene;

/** The fields of a report that describe the mass of what the hand holds. */
public final class MassFields {
  private MassFields() {}

  /** Returns mass and surplus energies. */
  public static Map<String, Object> of(MassiveContact body) {
    return of(body.kg(), body.takenMillijoule(), body.debtMillijoule());
  }

  /** Adds the field {@code mass} to a report if a rigid tool has one. */
  public static void put(Report report, ToolScene scene) {
    scene
        .mass()
        .ifPresent(
            body ->
                report.put("mass", of(body.kg(), body.takenMillijoule(), body.debtMillijoule())));
  }

  private static Map<String, Object> of(double kg, double takenMillijoule, double debtMillijoule) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("kg", kg);
    fields.put("taken_mj", takenMillijoule);
    fields.put("debt_mj", debtMillijoule);
    return fields;
  }
}
