package org.palpate.imagej.dialog;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticPlan;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.host.MaterialOverride;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.file.NumberParser;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * Materials of single segments, as the user writes them in the dialog and in macros: {@code
 * bone=stiffness:0.8,friction:0.3; skin=damping:0.001,young:20e3,poisson:0.4}.
 *
 * @param text the text as the user wrote it
 * @param choices overrides by the name of a segment
 * @param elastic the moduli of elastic segments by name
 */
public record StackMaterials(
    String text, Map<String, MaterialOverride> choices, Map<String, ElasticMaterial> elastic) {

  /** Copies the maps. */
  public StackMaterials {
    choices = Map.copyOf(choices);
    elastic = Map.copyOf(elastic);
  }

  /**
   * Parses materials that are separated by semicolons; none if the text is blank.
   *
   * @throws TouchRefusedException if the text has another form, names a segment twice, or lets a
   *     needle enter one
   */
  static StackMaterials parse(String text) throws TouchRefusedException {
    Map<String, MaterialOverride> choices = new LinkedHashMap<>();
    Map<String, ElasticMaterial> elastic = new LinkedHashMap<>();
    for (String part : text.split(";", -1)) {
      if (!part.isBlank()) {
        add(part.strip(), choices, elastic);
      }
    }
    return new StackMaterials(text.strip(), choices, elastic);
  }

  private static void add(
      String part, Map<String, MaterialOverride> choices, Map<String, ElasticMaterial> elastic)
      throws TouchRefusedException {
    int equals = part.lastIndexOf('='); // a segment's name may contain '=', a material may not
    String name = part.substring(0, Math.max(0, equals)).strip();
    List<String> rigid = new ArrayList<>();
    List<String> soft = new ArrayList<>();
    for (String figure : part.substring(equals + 1).replaceAll("\\s", "").split(",", -1)) {
      (figure.startsWith("young:") || figure.startsWith("poisson:") ? soft : rigid).add(figure);
    }
    Optional<MaterialOverride> choice =
        rigid.isEmpty()
            ? Optional.of(MaterialOverride.NONE)
            : MaterialOverride.parse(String.join(",", rigid));
    Optional<ElasticMaterial> modulus =
        ElasticMaterial.parse(String.join(",", soft), NumberParser::number);
    if (name.isEmpty() || choice.isEmpty() || soft.isEmpty() == modulus.isPresent()) {
      throw new TouchRefusedException(
          "\""
              + part
              + "\" is not a material: write for example bone=stiffness:0.8,friction:0.3,damping:0"
              + " or skin=young:20e3,poisson:0.4, with numbers of at least 0, sliding at most"
              + " friction, a modulus of 10 to 1e12 Pa, a ratio of 0 to 0.49, and semicolons"
              + " between segments.");
    }
    if (choice.get().isPenetrable()) {
      throw new TouchRefusedException(
          "\""
              + part
              + "\" lets a needle enter, and only palpate touch and replay have needles: leave"
              + " puncture, cutting and shaft out.");
    }
    if (choices.put(name, choice.get()) != null) {
      throw new TouchRefusedException("There are two materials for the segment \"" + name + "\".");
    }
    modulus.ifPresent(material -> elastic.put(name, material));
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

  /**
   * Returns what makes the elastic segments at rest, if there are any. One body is made at once, so
   * that whatever is wrong is found.
   *
   * @throws TouchRefusedException if the segments cannot be elastic
   */
  public Optional<Supplier<ElasticBody>> bodies(SegmentedVolume volume)
      throws TouchRefusedException {
    if (elastic.isEmpty()) {
      return Optional.empty();
    }
    ElasticPlan plan = ElasticPlan.of(volume, elastic, List.of(), OptionalDouble.empty());
    try {
      plan.get();
      return Optional.of(plan);
    } catch (IllegalArgumentException e) {
      throw new TouchRefusedException("The segments cannot be elastic: " + e.getMessage() + ".");
    }
  }
}
