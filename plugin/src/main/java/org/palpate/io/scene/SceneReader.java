package org.palpate.io.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.ReferencePose;

/** Reads a scene file. Errors are one line that names the file and the key. */
public final class SceneReader {
  private static final Set<String> TOP =
      Set.of("version", "bodies", "tool", "device", "protect", "carve");
  private static final Set<String> BODY =
      Set.of(
          "name",
          "volume",
          "mesh",
          "segment",
          "mobility",
          "pose",
          "material",
          "young_pa",
          "poisson");
  private static final Set<String> POSE = Set.of("translation_mm", "rotation");
  private static final Set<String> TOOL = Set.of("spec", "segment", "clearance", "mass_kg");
  private static final Set<String> DEVICE = Set.of("scale", "axes", "offset_mm");

  private final Path file;

  private SceneReader(Path file) {
    this.file = file;
  }

  /**
   * Reads a scene.
   *
   * @throws VolumeFormatException if the file cannot be read, has an unknown key, or a value is
   *     wrong
   */
  public static SceneFile read(Path file) throws VolumeFormatException {
    return new SceneReader(file).read();
  }

  private SceneFile read() throws VolumeFormatException {
    JsonFields top = new JsonFields(file, "", JsonValues.read(file), TOP);
    if (top.has("version") && !Double.valueOf(SceneFile.VERSION).equals(top.value("version"))) {
      throw top.refusal("version", "must be " + SceneFile.VERSION);
    }
    List<SceneBody> bodies = new ArrayList<>();
    List<SceneFill> fills = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (Object element : top.array("bodies")) {
      String path = "bodies[" + (bodies.size() + fills.size()) + "]";
      SceneBody body = body(path, element, names);
      if (body.segment().filter(text -> text.startsWith(SceneFill.PREFIX)).isPresent()) {
        fills.add(fill(top, path, body, bodies));
      } else if (fills.isEmpty()) {
        bodies.add(body);
      } else {
        throw top.refusal(path, "comes after a fill; move the fills to the end");
      }
    }
    if (bodies.isEmpty()) {
      throw top.refusal("bodies", "must have at least one body");
    }
    return new SceneFile(
        bodies, fills, tool(top), device(top), protect(top), top.positive("carve"));
  }

  /** Returns the fill that an elastic body describes. */
  private static SceneFill fill(
      JsonFields top, String path, SceneBody body, List<SceneBody> touchable)
      throws VolumeFormatException {
    boolean isPlain = body.pose().sameBits(new Pose()) && body.material().isEmpty();
    if (body.mobility() != Mobility.ELASTIC || !isPlain) {
      throw top.refusal(path, "is a fill, so it must be elastic and have no pose or material");
    }
    if (touchable.stream().noneMatch(other -> other.mobility() == Mobility.ELASTIC)) {
      throw top.refusal(path, "is a fill, and no body before it is elastic");
    }
    if (touchable.stream().noneMatch(other -> other.source().equals(body.source()))) {
      throw top.refusal(path + ".volume", "must be that of a body before the fill");
    }
    String segment = body.segment().orElseThrow().substring(SceneFill.PREFIX.length());
    return new SceneFill(
        body.name(), body.source(), segment, body.youngPa().orElseThrow(), body.poisson());
  }

  private SceneBody body(String path, Object value, Set<String> names)
      throws VolumeFormatException {
    JsonFields fields = new JsonFields(file, path, value, BODY);
    String name = fields.text("name");
    if (!names.add(name)) {
      throw fields.refusal(fields.key("name"), "is " + name + ", which another body has already");
    }
    boolean isMesh = fields.has("mesh");
    if (isMesh == fields.has("volume")) {
      throw fields.refusal(path, "must have either volume or mesh");
    }
    if (isMesh && fields.has("segment")) {
      throw fields.refusal(fields.key("segment"), "is for a volume, and the body is a mesh");
    }
    Mobility mobility = mobility(fields);
    checkElasticity(fields, mobility);
    return new SceneBody(
        name,
        fields.text(isMesh ? "mesh" : "volume"),
        isMesh,
        fields.optionalText("segment"),
        mobility,
        pose(fields),
        fields.optionalText("material"),
        fields.positive("young_pa"),
        poisson(fields));
  }

  private static Mobility mobility(JsonFields body) throws VolumeFormatException {
    String text = body.optionalText("mobility").orElse("fixed");
    for (Mobility mobility : Mobility.values()) {
      if (mobility.name().toLowerCase(Locale.ROOT).equals(text)) {
        return mobility;
      }
    }
    throw body.refusal(body.key("mobility"), "must be fixed, movable or elastic");
  }

  private static void checkElasticity(JsonFields body, Mobility mobility)
      throws VolumeFormatException {
    boolean isElastic = mobility == Mobility.ELASTIC;
    if (isElastic && !body.has("young_pa")) {
      throw body.refusal(body.key("young_pa"), "is missing, and the body is elastic");
    }
    for (String key : List.of("young_pa", "poisson")) {
      if (!isElastic && body.has(key)) {
        throw body.refusal(body.key(key), "is for an elastic body");
      }
    }
  }

  private static OptionalDouble poisson(JsonFields body) throws VolumeFormatException {
    if (!body.has("poisson")) {
      return OptionalDouble.empty();
    }
    if (body.value("poisson") instanceof Double ratio && ratio >= 0 && ratio < 0.5) {
      return OptionalDouble.of(ratio);
    }
    throw body.refusal(body.key("poisson"), "must be a number from 0 to below 0.5");
  }

  private Pose pose(JsonFields body) throws VolumeFormatException {
    Pose pose = new Pose();
    if (!body.has("pose")) {
      return pose;
    }
    JsonFields fields = new JsonFields(file, body.key("pose"), body.value("pose"), POSE);
    pose.translation.set(translation(fields));
    if (fields.has("rotation")) {
      double[] q = fields.numbers("rotation", 4);
      pose.rotation.set(q[0], q[1], q[2], q[3]);
      if (!pose.rotation.isNearUnit()) {
        throw fields.refusal(
            fields.key("rotation"), "has the norm " + pose.rotation.norm() + " instead of 1");
      }
      if (!pose.rotation.isUnit()) {
        pose.rotation.normalize();
      }
    }
    return pose;
  }

  /** Returns a translation that a movable body can have. */
  private static Vec3 translation(JsonFields pose) throws VolumeFormatException {
    Vec3 mm = pose.vector("translation_mm").orElseGet(Vec3::new);
    for (int axis = 0; axis < 3; axis++) {
      if (Math.abs(mm.get(axis)) > ReferencePose.LARGEST_MM) {
        throw pose.refusal(
            pose.key("translation_mm"),
            "must be from -1048576 to 1048576 mm along each axis: "
                + NumberText.text(mm.get(axis)));
      }
    }
    return mm;
  }

  private Optional<SceneTool> tool(JsonFields top) throws VolumeFormatException {
    if (!top.has("tool")) {
      return Optional.empty();
    }
    JsonFields fields = new JsonFields(file, "tool", top.value("tool"), TOOL);
    return Optional.of(
        new SceneTool(
            fields.text("spec"),
            fields.optionalText("segment"),
            clearance(fields),
            fields.positive("mass_kg")));
  }

  /** Returns the clearance, which may also be a number of mm. */
  private static Optional<String> clearance(JsonFields tool) throws VolumeFormatException {
    return tool.value("clearance") instanceof Double mm
        ? Optional.of(mm.toString())
        : tool.optionalText("clearance");
  }

  private Optional<SceneDevice> device(JsonFields top) throws VolumeFormatException {
    if (!top.has("device")) {
      return Optional.empty();
    }
    JsonFields fields = new JsonFields(file, "device", top.value("device"), DEVICE);
    Optional<String> axes = fields.optionalText("axes");
    if (!Set.of(SceneDevice.PATIENT, SceneDevice.VIEW).containsAll(axes.stream().toList())) {
      throw fields.refusal(fields.key("axes"), "must be patient or view");
    }
    return Optional.of(new SceneDevice(fields.positive("scale"), axes, fields.vector("offset_mm")));
  }

  private static List<String> protect(JsonFields top) throws VolumeFormatException {
    List<String> names = new ArrayList<>();
    for (Object element : top.array("protect")) {
      if (!(element instanceof String text) || text.isBlank()) {
        throw top.refusal("protect[" + names.size() + "]", "must be a text in quotes");
      }
      names.add(text);
    }
    return names;
  }
}
