package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.force.MassiveContact;

/** The fields of a report that describe the mass of an interaction point. */
public final class MassFields {
  private MassFields() {}

  /** Returns mass and surplus energies. */
  public static Map<String, Object> of(MassiveContact body) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("kg", body.kg());
    fields.put("taken_mj", body.takenMillijoule());
    fields.put("debt_mj", body.debtMillijoule());
    return fields;
  }
}
