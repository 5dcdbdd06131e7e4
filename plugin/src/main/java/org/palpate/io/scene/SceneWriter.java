package org.palpate.io.scene;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.body.BodyGroups;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.GroupsCsv;
import org.palpate.io.table.ReportJson;

/**
 * Writes a scene file. Doubles are the shortest decimals that read back the same, so a scene that
 * is written and read has the same bits.
 */
public final class SceneWriter {
  private SceneWriter() {}

  /**
   * Replaces a scene file and the table of locks and groups beside it, which is deleted if no body
   * is locked and each moves alone. If something cannot be written, both stay as they are.
   *
   * @param bodies the names of all bodies in the order of the scene
   * @return the table; empty if there is none
   * @throws IOException if that is not possible
   */
  public static Optional<Path> replace(
      Path file, SceneFile scene, List<String> bodies, BodyGroups groups) throws IOException {
    Optional<Path> place = tableOf(file);
    Optional<Path> table = place.filter(each -> GroupsCsv.isNeeded(bodies.size(), groups));
    try (AtomicFile rows = table.isPresent() ? new AtomicFile(table.get()) : null;
        AtomicFile target = new AtomicFile(file)) {
      if (rows != null) {
        GroupsCsv.write(rows.stream(), bodies, groups);
        rows.stream().flush();
      }
      write(scene, target.stream());
      target.stream().flush(); // a full disk shows before anything is replaced
      if (rows != null) {
        rows.commit();
      } else if (place.isPresent()) {
        Files.deleteIfExists(place.get());
      }
      target.commit();
    }
    return table;
  }

  /**
   * Returns where the locks and groups of a scene are written; empty if the scene goes to a pipe or
   * a terminal, beside which there is none.
   */
  public static Optional<Path> tableOf(Path file) {
    return AtomicFile.isDirect(file) ? Optional.empty() : Optional.of(GroupsCsv.beside(file));
  }

  /** Writes a scene and leaves the stream open. The names of files are written as they are. */
  public static void write(SceneFile scene, OutputStream stream) throws IOException {
    Map<String, Object> top = new LinkedHashMap<>();
    top.put("version", SceneFile.VERSION);
    List<Map<String, Object>> bodies = new ArrayList<>();
    scene.bodies().forEach(body -> bodies.add(body(body)));
    scene.fills().forEach(fill -> bodies.add(fill(fill)));
    top.put("bodies", bodies);
    scene.tool().ifPresent(tool -> top.put("tool", tool(tool)));
    scene.device().ifPresent(device -> top.put("device", device(device)));
    if (!scene.protect().isEmpty()) {
      top.put("protect", scene.protect());
    }
    scene.carve().ifPresent(rate -> top.put("carve", rate));
    ReportJson.write(top, stream);
  }

  private static Map<String, Object> body(SceneBody body) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("name", body.name());
    fields.put(body.isMesh() ? "mesh" : "volume", body.source());
    body.segment().ifPresent(segment -> fields.put("segment", segment));
    fields.put("mobility", body.mobility().name().toLowerCase(Locale.ROOT));
    fields.put("pose", pose(body.pose()));
    body.material().ifPresent(material -> fields.put("material", material));
    body.youngPa().ifPresent(young -> fields.put("young_pa", young));
    body.poisson().ifPresent(ratio -> fields.put("poisson", ratio));
    return fields;
  }

  private static Map<String, Object> fill(SceneFill fill) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("name", fill.name());
    fields.put("volume", fill.source());
    fields.put("segment", SceneFill.PREFIX + fill.segment());
    fields.put("mobility", Mobility.ELASTIC.name().toLowerCase(Locale.ROOT));
    fields.put("young_pa", fill.youngPa());
    fill.poisson().ifPresent(ratio -> fields.put("poisson", ratio));
    return fields;
  }

  private static Map<String, Object> pose(Pose pose) {
    Quaternion q = pose.rotation;
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("translation_mm", vector(pose.translation));
    fields.put("rotation", List.of(q.w, q.x, q.y, q.z));
    return fields;
  }

  private static List<Double> vector(Vec3 v) {
    return List.of(v.x, v.y, v.z);
  }

  private static Map<String, Object> tool(SceneTool tool) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("spec", tool.spec());
    tool.segment().ifPresent(segment -> fields.put("segment", segment));
    tool.clearance().ifPresent(clearance -> fields.put("clearance", clearance));
    tool.massKg().ifPresent(mass -> fields.put("mass_kg", mass));
    return fields;
  }

  private static Map<String, Object> device(SceneDevice device) {
    Map<String, Object> fields = new LinkedHashMap<>();
    device.scale().ifPresent(scale -> fields.put("scale", scale));
    device.axes().ifPresent(axes -> fields.put("axes", axes));
    device.offsetMm().ifPresent(offset -> fields.put("offset_mm", vector(offset)));
    return fields;
  }
}
