package org.palpate.imagej.dialog;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.host.MaterialOverride;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.volume.Segment;

/**
 * Materials of single segments, as the user writes them in the dialog and in macros: {@code
 * bone=stiffness:0.8,friction:0.3; skin=damping:0.001}.
 *
 * @param text the text as the user wrote it
 * @param choices overrides by the name of a segment
 */
public record StackMaterials(String text, Map<String, MaterialOverride> choices) {

  /** Copies the map. */
  public StackMaterials {
    choices = Map.copyOf(choices);
  }

  /**
   * Parses materials that are separated by semicolons; none if the text is blank.
   *
   * @throws TouchRefusedException if the text has another form or names a segment twice
   */
  static StackMaterials parse(String text) throws TouchRefusedException {
    Map<String, MaterialOverride> choices = new LinkedHashMap<>();
    for (String part : text.split(";", -1)) {
      if (!part.isBlank()) {
        add(part.strip(), choices);
      }
    }
    return new StackMaterials(text.strip(), choices);
  }

  private static void add(String part, Map<String, MaterialOverride> choices)
      throws TouchRefusedException {
    int equals = part.lastIndexOf('='); // a segment's name may contain '=', a material may not
    String name = part.substring(0, Math.max(0, equals)).strip();
    MaterialOverride choice =
        MaterialOverride.parse(part.substring(equals + 1).replaceAll("\\s", "")).orElse(null);
    if (name.isEmpty() || choice == null) {
      throw new TouchRefusedException(
          "\""
              + part
              + "\" is not a material: write for example bone=stiffness:0.8,friction:0.3,damping:0,"
              + " with numbers of at least 0, sliding at most friction, and semicolons between"
              + " segments.");
    }
    if (choices.put(name, choice) != null) {
      throw new TouchRefusedException("There are two materials for the segment \"" + name + "\".");
    }
  }

  /**
   * Checks that every named segment exists.
   *
   * @throws TouchRefusedException if one does not
   */
  public void checkNamed(List<Segment> segments) throws TouchRefusedException {
    List<String> names = segments.stream().map(Segment::name).toList();
    for (String name : choices.keySet()) {
      if (!names.contains(name)) {
        throw new TouchRefusedException(
            "There is no segment \""
                + name
                + "\" for this material: choose one of "
                + String.join(", ", names)
                + ".");
      }
    }
  }
}
