package org.palpate.app.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.options.OutputPaths;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VersionProvider;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.ReportJson;
import org.palpate.volume.Segment;
import org.palpate.volume.VoxelGrid;

/**
 * What a command measured, field by field in the order in which it is written. One thread.
 *
 * <p>Its file is tried when the command starts, so that a wrong path is told before the work.
 */
public final class Report {
  private final Optional<Path> file;
  private final Map<String, Object> fields = new LinkedHashMap<>();

  /**
   * A report that every command begins with: version, Java, command.
   *
   * @param file where it goes; nothing is written where there is none
   * @param inputs files that must not be written
   * @throws PalpateException exit code 2, where the file cannot be written or is an input
   */
  public Report(String command, Optional<Path> file, List<Path> inputs) {
    this.file = file.map(path -> OutputPaths.checked("--report", path, inputs));
    fields.put("version", VersionProvider.version());
    fields.put("java", Runtime.version() + " " + System.getProperty("java.vm.name"));
    fields.put("command", command);
  }

  /** Whether anyone asked for it. */
  public boolean isWanted() {
    return file.isPresent();
  }

  /** Adds a field: a string, number, boolean, null, or a map or list of such. */
  public Report put(String name, Object value) {
    fields.put(name, value);
    return this;
  }

  /** The fields so far, in order; not to be changed. */
  public Map<String, Object> fields() {
    return Collections.unmodifiableMap(fields);
  }

  /** Adds what is known of the volume. Reads it once for its checksum. */
  public void putVolume(VolumeSource source, List<Segment> segments) throws IOException {
    VoxelGrid grid = source.header().grid();
    Vec3 spacing = grid.spacingMm();
    put("volume", source.name());
    put("sizes", List.of(grid.sizeX(), grid.sizeY(), grid.sizeZ()));
    put("spacing_mm", List.of(spacing.x, spacing.y, spacing.z));
    put("sha256", source.sha256());
    List<Object> entries = new ArrayList<>();
    segments.forEach(segment -> entries.add(entry(segment)));
    put("segments", entries);
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
   * Writes it, if anyone asked for it.
   *
   * @throws PalpateException exit code 1, where the disk refuses
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
