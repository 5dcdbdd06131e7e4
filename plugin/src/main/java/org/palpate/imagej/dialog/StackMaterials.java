package org.palpate.imagej.dialog;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.host.MaterialOverride;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.volume.Segment;

/**
 * What of some segments feels otherwise than the rest, as it is written in the dialog and in
 * macros: {@code bone=stiffness:0.8,friction:0.3; skin=damping:0.001}.
 *
 * @param text as it was written
 * @param choices by the name of a segment
 */
public record StackMaterials(String text, Map<String, MaterialOverride> choices) {

  /** Keeps a copy of the map. */
  public StackMaterials {
    choices = Map.copyOf(choices);
  }

  /**
   * Reads segments parted by semicolons; nothing where the text is blank.
   *
   * @throws TouchRefusedException where it is not that, or names a segment twice
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
    int equals = part.lastIndexOf('='); // a label may be named with one, a material is not
    String name = part.substring(0, Math.max(0, equals)).strip();
    MaterialOverride choice =
        MaterialOverride.parse(part.substring(equals + 1).replaceAll("\\s", "")).orElse(null);
    if (name.isEmpty() || choice == null) {
      throw new TouchRefusedException(
          "\""
              + part
              + "\" is not a material: write it as in bone=stiffness:0.8,friction:0.3,damping:0, "
              + "numbers from 0 up, sliding at most friction, segments parted by semicolons.");
    }
    if (choices.put(name, choice) != null) {
      throw new TouchRefusedException("There are two materials for the segment \"" + name + "\".");
    }
  }

  /**
   * Sees to it that each is a material of a segment that there is.
   *
   * @throws TouchRefusedException where one is not
   */
  public void checkNamed(List<Segment> segments) throws TouchRefusedException {
    List<String> names = segments.stream().map(Segment::name).toList();
    for (String name : choices.keySet()) {
      if (!names.contains(name)) {
        throw new TouchRefusedException(
            "There is no segment \""
                + name
                + "\" to have a material: choose one of "
                + String.join(", ", names)
                + ".");
      }
    }
  }
}
