package org.palpate.benchmarks.jitter.experiment;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.process.PalpateException;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/**
 * The touched scene as text, which the command passes to the process of an experiment. Each line is
 * a word and a value: {@code phantom head:256}, or {@code volume FILE}, {@code raw LAYOUT} and any
 * number of {@code segment NAME=SPEC}.
 */
public final class ExperimentScene {
  private ExperimentScene() {}

  /** Converts the options of the command line to text. */
  public static String textOf(VolumeOptions options) {
    if (options.volume().isEmpty()) {
      return "phantom " + options.phantom();
    }
    if (options.segments().isEmpty()) {
      throw PalpateException.wrongUse(
          "which values are solid is not said",
          "--volume " + options.volume().get(),
          "choose with --segment, for example --segment 'bone=>=1500'");
    }
    StringJoiner lines = new StringJoiner("\n");
    lines.add("volume " + options.volume().get().toAbsolutePath());
    options.raw().ifPresent(layout -> lines.add("raw " + layout));
    options.segments().forEach(segment -> lines.add("segment " + segment));
    return lines.toString();
  }

  /**
   * Checks the header of the file and the segments, so that a mistake shows before any experiment
   * runs.
   *
   * @throws VolumeFormatException if the file or a segment is not understood
   */
  public static void check(String text) throws VolumeFormatException {
    Parsed parsed = parse(text);
    if (parsed.file() != null) {
      VolumeFiles.open(parsed.file(), parsed.options());
    }
  }

  /**
   * Makes or reads the volume.
   *
   * @throws VolumeFormatException if the file is not understood
   */
  static SegmentedVolume read(String text) throws VolumeFormatException {
    Parsed parsed = parse(text);
    return parsed.file() == null
        ? parsed.phantom().segments()
        : SegmentBuilder.read(VolumeFiles.open(parsed.file(), parsed.options()), parsed.segments());
  }

  private static Parsed parse(String text) throws VolumeFormatException {
    Path file = null;
    Phantom phantom = null;
    ReadOptions options = ReadOptions.defaults();
    List<SegmentSpec> segments = new ArrayList<>();
    for (String line : text.lines().toList()) {
      String value = line.substring(line.indexOf(' ') + 1);
      switch (line.substring(0, line.indexOf(' '))) {
        case "phantom" -> phantom = phantomOf(value);
        case "volume" -> file = Path.of(value);
        case "raw" -> options = options.withRaw(RawLayout.parse(value));
        case "segment" -> segments.add(SegmentSpec.parse(value));
        default -> throw new IllegalArgumentException("not a scene: " + text);
      }
    }
    return new Parsed(phantom, file, options, segments);
  }

  private static Phantom phantomOf(String spec) {
    try {
      return Phantom.parse(spec);
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(
          e.getMessage(), "--phantom " + spec, "write NAME[:EDGE], as in head:256", e);
    }
  }

  private record Parsed(
      Phantom phantom, Path file, ReadOptions options, List<SegmentSpec> segments) {}
}
