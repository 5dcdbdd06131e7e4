package org.palpate.app.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VersionProvider;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.table.ReportJson;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The measurements of a command, field by field in the order in which they are written. One thread.
 *
 * <p>The target is checked when the command starts, so that a wrong path is reported before the
 * work.
 */
public final class Report {
  private final Optional<Path> file;
  private final Map<String, Object> fields = new LinkedHashMap<>();

  /**
   * Creates a report with the fields of every command: version, Java and command.
   *
   * @param file the target; if empty, nothing is written
   * @param inputs files that must not be replaced
   * @throws PalpateException exit code 2, if the file cannot be written or is an input
   */
  public Report(String command, Optional<Path> file, List<Path> inputs) {
    this.file = file.map(path -> OutputPaths.checked("--report", path, inputs));
    fields.put("version", VersionProvider.version());
    fields.put("java", Runtime.version() + " " + System.getProperty("java.vm.name"));
    fields.put("command", command);
  }

  /** Whether the user asked for a report. */
  public boolean isWanted() {
    return file.isPresent();
  }

  /** Adds a field: a string, number, boolean, null, or a map or list of these. */
  public Report put(String name, Object value) {
    fields.put(name, value);
    return this;
  }

  /** Returns an unmodifiable view of the fields in order. */
  public Map<String, Object> fields() {
    return Collections.unmodifiableMap(fields);
  }

  /** Adds the properties of the volume. Reads it once for its checksum. */
  public void putVolume(VolumeSource source, List<Segment> segments) throws IOException {
    VoxelGrid grid = source.header().grid();
    put("volume", source.name());
    put("sizes", List.of(grid.sizeX(), grid.sizeY(), grid.sizeZ()));
    put("spacing_mm", numbers(grid.spacingMm()));
    put("sha256", source.sha256());
    List<Object> entries = new ArrayList<>();
    segments.forEach(segment -> entries.add(entry(segment)));
    put("segments", entries);
    source
        .placed()
        .map(PlacedVolume::rest)
        .filter(bodies -> !bodies.hasOneGrid())
        .ifPresent(bodies -> put("bodies", grids(bodies)));
  }

  /** Returns the grid of each body, in which legs are written. */
  private static List<Object> grids(SegmentedVolume bodies) {
    List<Object> entries = new ArrayList<>();
    for (Segment body : bodies.segments()) {
      VoxelGrid grid = bodies.grid(entries.size());
      RigidTransform toWorld = grid.gridMmToWorld();
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("name", body.name());
      entry.put("sizes", List.of(grid.sizeX(), grid.sizeY(), grid.sizeZ()));
      entry.put("spacing_mm", numbers(grid.spacingMm()));
      entry.put("origin_mm", numbers(toWorld.origin()));
      entry.put(
          "axes",
          List.of(numbers(toWorld.axisX()), numbers(toWorld.axisY()), numbers(toWorld.axisZ())));
      entry.put("voxels", body.bits().solidCount());
      entries.add(entry);
    }
    return entries;
  }

  private static List<Double> numbers(Vec3 v) {
    return List.of(v.x, v.y, v.z);
  }

  private static Map<String, Object> entry(Segment segment) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", segment.name());
    entry.put("voxels", segment.bits().solidCount());
    IntBox box = segment.bits().bounds();
    if (!box.isEmpty()) {
      Map<String, Object> ends = new LinkedHashMap<>();
      ends.put("x", List.of(box.lowX, box.highX));
      ends.put("y", List.of(box.lowY, box.highY));
      ends.put("z", List.of(box.lowZ, box.highZ));
      entry.put("box", ends);
    }
    return entry;
  }

  /**
   * Writes the report if the user asked for it.
   *
   * @throws PalpateException exit code 1, if it cannot be written
   */
  public void write() {
    if (file.isEmpty()) {
      return;
    }
    try (AtomicFile target = new AtomicFile(file.get())) {
      ReportJson.write(fields, target.stream());
      target.commit();
    } catch (IOException e) {
      throw OutputPaths.failed(file.get(), e);
    }
  }
}
