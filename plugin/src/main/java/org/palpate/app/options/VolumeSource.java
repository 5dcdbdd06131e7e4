package org.palpate.app.options;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.ProgressLine;
import org.palpate.io.GreyVolumes;
import org.palpate.io.PhantomReader;
import org.palpate.io.VolumeDigest;
import org.palpate.io.VolumeFiles;
import org.palpate.io.file.NumberText;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.label.ValueStatistics;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/** The volume that a command is about: its header understood, its values not read yet. */
public final class VolumeSource {
  private final String name;
  private final VolumeReader reader;
  private final Optional<Phantom> phantom;
  private final List<SegmentSpec> asked;
  private ScalarVolume greyValues;

  private VolumeSource(
      String name, VolumeReader reader, Optional<Phantom> phantom, List<SegmentSpec> asked) {
    this.name = name;
    this.reader = reader;
    this.phantom = phantom;
    this.asked = asked;
  }

  /**
   * Opens what the options name.
   *
   * @throws VolumeFormatException where a file or an option is not understood
   */
  public static VolumeSource open(VolumeOptions options) throws VolumeFormatException {
    List<SegmentSpec> asked = parseSegments(options.segments());
    Optional<Path> file = options.volume();
    if (file.isEmpty()) {
      Phantom phantom = parsePhantom(options.phantom());
      return new VolumeSource(
          "phantom " + phantom.spec(), new PhantomReader(phantom), Optional.of(phantom), asked);
    }
    return new VolumeSource(
        file.get().toString(),
        VolumeFiles.open(file.get(), reading(options)),
        Optional.empty(),
        asked);
  }

  private static ReadOptions reading(VolumeOptions options) throws VolumeFormatException {
    ReadOptions reading =
        ReadOptions.defaults()
            .withProgress(new ProgressLine("reading"))
            .withResample(options.resample());
    if (options.raw().isPresent()) {
      reading = reading.withRaw(RawLayout.parse(options.raw().get()));
    }
    if (options.time().isPresent()) {
      reading = reading.withTime(options.time().getAsInt());
    }
    return options.series().isPresent() ? reading.withSeries(options.series().get()) : reading;
  }

  private static List<SegmentSpec> parseSegments(List<String> texts) throws VolumeFormatException {
    List<SegmentSpec> specs = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (String text : texts) {
      SegmentSpec spec = SegmentSpec.parse(text);
      if (!names.add(spec.name())) {
        throw PalpateException.wrongUse(
            "two segments have one name", "--segment " + text, "give each its own name");
      }
      specs.add(spec);
    }
    return specs;
  }

  private static Phantom parsePhantom(String spec) {
    try {
      return Phantom.parse(spec);
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(e.getMessage(), e);
    }
  }

  /** The file or the phantom, for a person. */
  public String name() {
    return name;
  }

  public VolumeHeader header() {
    return reader.header();
  }

  public VolumeReader reader() {
    return reader;
  }

  /** The segments that were asked for by {@code --segment}. */
  public List<SegmentSpec> asked() {
    return asked;
  }

  /** The files that must not be written. */
  public List<Path> files() {
    return reader.files();
  }

  /** SHA-256 of the files, or of the phantom's values. */
  public String sha256() throws IOException {
    return VolumeDigest.sha256(reader);
  }

  /**
   * Reads the segments that were asked for, or one for each label.
   *
   * @param err is told which of them have no voxel
   * @throws PalpateException exit code 2, where none was asked for and the values are intensities
   */
  public SegmentedVolume segments(PrintWriter err) throws VolumeFormatException {
    if (!asked.isEmpty()) {
      SegmentedVolume found = read(asked);
      found.segments().stream()
          .filter(segment -> segment.bits().solidCount() == 0)
          .forEach(segment -> err.println(emptyLine(segment)));
      err.flush();
      return found;
    }
    if (phantom.isPresent() && !phantom.get().grey()) {
      return phantom.get().segments();
    }
    ValueStatistics.Found found = survey();
    if (isIntensities(found)) {
      throw refusal(found);
    }
    return read(specsOf(found.labels()));
  }

  /**
   * The grey values that the one segment was made of by a threshold; empty where it was made
   * otherwise, or where there are several.
   */
  Optional<GreyIsosurface> greySurface() throws VolumeFormatException {
    if (asked.size() != 1
        || !(asked.get(0).rule() instanceof SegmentSpec.Range range)
        || Double.isInfinite(range.low())
        || !Double.isInfinite(range.high())) {
      return Optional.empty();
    }
    return Optional.of(GreyIsosurface.ofThreshold(greyValues(), range.low()));
  }

  /** All grey values, read once and kept. */
  ScalarVolume greyValues() throws VolumeFormatException {
    if (greyValues == null) {
      greyValues = GreyVolumes.read(reader);
    }
    return greyValues;
  }

  /** Whether {@link #greyValues} costs nothing any more. */
  public boolean hasGreyValues() {
    return greyValues != null;
  }

  /** Reads segments by the given rules. */
  public SegmentedVolume read(List<SegmentSpec> specs) throws VolumeFormatException {
    return SegmentBuilder.read(reader, specs);
  }

  private String emptyLine(Segment segment) {
    return "palpate: segment "
        + segment.name()
        + " has no voxel: "
        + name
        + ": palpate info tells its values";
  }

  private ValueStatistics.Found survey() throws VolumeFormatException {
    ValueStatistics survey = new ValueStatistics(header());
    reader.read(survey);
    return survey.found();
  }

  /** Whether its values are more than labels; one pass over them. */
  boolean holdsIntensities() throws VolumeFormatException {
    return isIntensities(survey());
  }

  /** Whether it takes a person to say which values are solid. */
  public boolean isIntensities(ValueStatistics.Found found) {
    return found.labels().isEmpty() || phantom.map(Phantom::grey).orElse(false);
  }

  /** A segment for each label, by the names of the file where it has any. */
  public List<SegmentSpec> specsOf(List<Long> labels) {
    List<SegmentSpec> specs = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (long label : labels) {
      String name = header().labels().map(table -> nameIn(table, label)).orElse("label" + label);
      SegmentSpec spec = SegmentSpec.labels(names.add(name) ? name : name + "-" + label, label);
      int rgb = header().labels().map(table -> rgbIn(table, label)).orElse(spec.rgb());
      specs.add(spec.withRgb(rgb));
    }
    return specs;
  }

  private static String nameIn(LabelTable table, long label) {
    LabelTable.Label known = table.labels().get(label);
    return known == null || known.name().isBlank() ? "label" + label : known.name();
  }

  private static int rgbIn(LabelTable table, long label) {
    LabelTable.Label known = table.labels().get(label);
    return known == null ? SegmentSpec.ANY_COLOUR : known.rgb();
  }

  private PalpateException refusal(ValueStatistics.Found found) {
    return PalpateException.wrongUse(
        "which values are solid is not known, they run from "
            + NumberText.people(found.low())
            + " to "
            + NumberText.people(found.high()),
        name,
        "choose with --segment, for example " + proposal(found));
  }

  /** Arguments to try, for a person. */
  public String proposal(ValueStatistics.Found found) {
    List<String> proposals = new ArrayList<>();
    if (phantom.isPresent()) {
      phantom.get().thresholds().forEach(t -> proposals.add(argument(t.name(), t.atLeast())));
    } else if (found.thresholds().size() == 2) {
      proposals.add(argument("bone", found.thresholds().get(1)));
      proposals.add(argument("tissue", found.thresholds().get(0)));
    } else {
      proposals.add("--segment all=nonzero");
    }
    return String.join(" or ", proposals);
  }

  private static String argument(String name, double atLeast) {
    return String.format(
        Locale.ROOT, "--segment '%s=>=%s'", name, NumberText.people(rounded(atLeast)));
  }

  /** To three digits, for a threshold is no more than a proposal. */
  private static double rounded(double value) {
    if (value == 0) {
      return 0;
    }
    double unit = Math.pow(10, Math.floor(Math.log10(Math.abs(value))) - 2);
    return unit >= 1 ? Math.rint(value / unit) * unit : Math.rint(value * (1 / unit)) / (1 / unit);
  }
}
