package org.palpate.app.options;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.ProgressLine;
import org.palpate.body.Placement;
import org.palpate.io.GreyVolumes;
import org.palpate.io.PhantomReader;
import org.palpate.io.VolumeDigest;
import org.palpate.io.VolumeFiles;
import org.palpate.io.file.NumberText;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.label.ValueStatistics;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.OpenedScene;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneFill;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
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
import org.palpate.volume.SpecificationException;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.phantom.FracturePhantom;
import org.palpate.volume.phantom.Phantom;

/** The volume of a command: its header is read, its values are not read yet. One thread. */
public final class VolumeSource {
  private final String name;
  private final VolumeReader reader;
  private final Optional<Phantom> phantom;
  private final List<SegmentSpec> requested;
  private final Optional<PlacedVolume> placed;
  private final boolean isElastic;
  private ScalarVolume greyValues;

  private VolumeSource(
      String name, VolumeReader reader, Optional<Phantom> phantom, List<SegmentSpec> requested) {
    this.name = name;
    this.reader = reader;
    this.phantom = phantom;
    this.requested = requested;
    placed = Optional.empty();
    isElastic = false;
  }

  /**
   * Creates the source of placed bodies; its reader shows them where they stand, as labels.
   *
   * @param isElastic whether some are elastic, so that all stand at rest
   */
  private VolumeSource(
      String name, PlacedVolume placed, List<SegmentSpec> requested, boolean isElastic) {
    this.name = name;
    this.isElastic = isElastic;
    this.placed = Optional.of(placed);
    reader =
        new SegmentsAsLabels(
            name, placed.present(), placed.world(), placed.files(), placed.exportNotes());
    phantom = Optional.empty();
    this.requested = requested;
  }

  /**
   * Opens the volume that the options name.
   *
   * @throws VolumeFormatException if a file or an option cannot be understood
   */
  public static VolumeSource open(VolumeOptions options) throws VolumeFormatException {
    List<SegmentSpec> requested = parseSegments(options.segments());
    ReadOptions reading = readOptions(options);
    Optional<Path> file = options.volume();
    if (options.scene().isPresent()) {
      Path scene = options.scene().get();
      SceneFile read = SceneReader.read(scene);
      PlacedVolume bodies = BodyReader.read(read, scene);
      return new VolumeSource("scene " + scene, bodies, requested, read.isElastic());
    }
    if (file.isEmpty() && FracturePhantom.accepts(options.phantom())) {
      return ofFracture(phantom(FracturePhantom::parse, options.phantom()), requested);
    }
    if (file.isEmpty()) {
      Phantom phantom = phantom(Phantom::parse, options.phantom());
      return new VolumeSource(
          "phantom " + phantom.spec(), new PhantomReader(phantom), Optional.of(phantom), requested);
    }
    return new VolumeSource(
        file.get().toString(), VolumeFiles.open(file.get(), reading), Optional.empty(), requested);
  }

  /**
   * Returns the volume of a reader, with the segments that the options ask for.
   *
   * @throws VolumeFormatException if an option cannot be understood
   */
  public static VolumeSource of(VolumeReader reader, VolumeOptions options)
      throws VolumeFormatException {
    return new VolumeSource(
        reader.sourceName(), reader, Optional.empty(), parseSegments(options.segments()));
  }

  private static ReadOptions readOptions(VolumeOptions options) throws VolumeFormatException {
    ReadOptions readOptions =
        ReadOptions.defaults()
            .withProgress(new ProgressLine("reading"))
            .withResample(options.resample());
    if (options.raw().isPresent()) {
      readOptions = readOptions.withRaw(RawLayout.parse(options.raw().get()));
    }
    if (options.time().isPresent()) {
      readOptions = readOptions.withTimeStep(options.time().getAsInt());
    }
    return options.series().isPresent()
        ? readOptions.withSeries(options.series().get())
        : readOptions;
  }

  private static List<SegmentSpec> parseSegments(List<String> texts) throws VolumeFormatException {
    List<SegmentSpec> specs = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (String text : texts) {
      SegmentSpec spec = SegmentSpec.parse(text);
      if (!names.add(spec.name())) {
        throw PalpateException.wrongUse(
            "two segments have the same name", "--segment " + text, "give each its own name");
      }
      specs.add(spec);
    }
    return specs;
  }

  private static VolumeSource ofFracture(FracturePhantom phantom, List<SegmentSpec> requested) {
    return new VolumeSource(
        "phantom " + phantom.spec(), parsed(VolumeSource::broken, phantom), requested, false);
  }

  /** Returns the fragments of a bone, displaced; all but the first, the largest, are movable. */
  private static PlacedVolume broken(FracturePhantom phantom) {
    Fragments fragments = phantom.fragments();
    return PlacedVolume.ofFragments(
        fragments, phantom.startPoses(fragments), CoordinateSystem.UNKNOWN);
  }

  /**
   * Returns the phantom of a specification. If it is refused, the message names the option as the
   * user wrote it instead of the value.
   */
  private static <R> R phantom(Function<String, R> parser, String spec) {
    try {
      return parser.apply(spec);
    } catch (SpecificationException e) {
      throw PalpateException.wrongUse(e.what(), "--phantom " + spec, e.remedy(), e);
    }
  }

  /** Returns what a function makes of an option; what it refuses is wrong use. */
  private static <T, R> R parsed(Function<T, R> function, T option) {
    try {
      return function.apply(option);
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(e.getMessage(), e);
    }
  }

  /** Returns the file or phantom as the user knows it. */
  public String name() {
    return name;
  }

  /** Returns the header. */
  public VolumeHeader header() {
    return reader.header();
  }

  /** Returns the reader of the values. */
  public VolumeReader reader() {
    return reader;
  }

  /** Returns the segments that {@code --segment} asked for. */
  public List<SegmentSpec> requested() {
    return requested;
  }

  /**
   * Returns the files of the volume, and the locks and groups beside a scene, which no output may
   * replace.
   */
  public List<Path> files() {
    List<Path> files = new ArrayList<>(reader.files());
    placed.flatMap(PlacedVolume::groupsFile).filter(Files::exists).ifPresent(files::add);
    return files;
  }

  /** Returns the placement of each segment of a scene; empty if the segments stand at rest. */
  public List<Placement> placements() {
    return placed().map(PlacedVolume::placements).orElse(List.of());
  }

  /**
   * Returns the bodies of a scene and their placements; empty if this is no scene, if some of its
   * bodies are elastic and so all stand at rest, or if {@code --segment} asked for other segments
   * of what it shows.
   */
  public Optional<PlacedVolume> placed() {
    return isElastic ? Optional.empty() : bodies();
  }

  private Optional<PlacedVolume> bodies() {
    return requested.isEmpty() ? placed : Optional.empty();
  }

  /**
   * Returns the fills of a scene file, each as a segment with its voxels.
   *
   * @throws VolumeFormatException if one cannot be read
   */
  public List<Segment> fills() throws VolumeFormatException {
    List<Segment> fills = new ArrayList<>();
    Optional<OpenedScene> origin = placed.flatMap(PlacedVolume::origin);
    if (origin.isPresent()) {
      for (SceneFill fill : origin.get().scene().fills()) {
        fills.add(new Segment(fill.name(), fill.voxels(origin.get().file()), 0));
      }
    }
    return fills;
  }

  /** Whether the bodies come from files that a scene names. */
  public boolean isScene() {
    return placed.flatMap(PlacedVolume::origin).isPresent();
  }

  /**
   * Returns the scene that was read; empty if there is none, or if {@code --segment} chose other
   * segments in it.
   */
  public Optional<OpenedScene> origin() {
    return bodies().flatMap(PlacedVolume::origin);
  }

  /** Returns the shortest voxel edge of the volume and of all bodies, mm. */
  double shortestEdgeMm() {
    return placed()
        .map(bodies -> bodies.rest().shortestEdgeMm())
        .orElseGet(() -> header().grid().metric().shortestEdgeMm());
  }

  /** Returns the SHA-256 of the files, or of the phantom's values. */
  public String sha256() throws IOException {
    return VolumeDigest.sha256(reader);
  }

  /**
   * Reads the segments that were asked for, otherwise one for each label. Those of a scene are
   * where they rest; see {@link #placements}.
   *
   * @param err receives a line for each segment without voxels and each note about a scene
   * @param keepsGrey whether to keep the grey values too, in the same pass over the file, if
   *     segments were asked for
   * @throws PalpateException exit code 2, if no segment was asked for and the values are
   *     intensities
   */
  public SegmentedVolume segments(PrintWriter err, boolean keepsGrey) throws VolumeFormatException {
    if (bodies().isPresent()) {
      bodies().get().notes().forEach(err::println);
      err.flush();
      return bodies().get().rest();
    }
    if (!requested.isEmpty()) {
      SegmentedVolume found = keepsGrey ? readWithGreyValues() : read(requested);
      found.segments().stream()
          .filter(segment -> segment.bits().solidCount() == 0)
          .forEach(segment -> err.println(emptyLine(segment.name())));
      err.flush();
      return found;
    }
    if (phantom.isPresent() && !phantom.get().grey()) {
      return phantom.get().segments();
    }
    ValueStatistics.Summary found = statistics();
    emptySegments(found.labels()).forEach(empty -> err.println(emptyLine(empty)));
    err.flush();
    if (isIntensities(found)) {
      throw noSegmentChosen(found);
    }
    return read(specsOf(found.labels()));
  }

  /**
   * Returns the names of the segments that the volume itself lists and that have no voxel.
   *
   * @param labels the labels that occur
   */
  public List<String> emptySegments(List<Long> labels) {
    return header().labels().filter(LabelTable::isComplete).stream()
        .flatMap(table -> table.labels().entrySet().stream())
        .filter(entry -> entry.getKey() != 0 && !labels.contains(entry.getKey()))
        .map(entry -> entry.getValue().name())
        .toList();
  }

  /**
   * Returns the isosurface of grey values if exactly one segment was asked for, by a threshold;
   * empty otherwise.
   */
  Optional<GreyIsosurface> greySurface() throws VolumeFormatException {
    OptionalDouble threshold = threshold();
    return threshold.isPresent()
        ? Optional.of(GreyIsosurface.ofThreshold(greyValues(), threshold.getAsDouble()))
        : Optional.empty();
  }

  /** Returns the threshold if exactly one segment was asked for, by a threshold. */
  OptionalDouble threshold() {
    return requested.size() == 1
            && requested.get(0).rule() instanceof SegmentSpec.Range range
            && !Double.isInfinite(range.low())
            && Double.isInfinite(range.high())
        ? OptionalDouble.of(range.low())
        : OptionalDouble.empty();
  }

  /** Returns the lower threshold of the first segment that was asked for by a range of values. */
  OptionalDouble firstThreshold() {
    return requested.stream()
        .filter(spec -> spec.rule() instanceof SegmentSpec.Range)
        .mapToDouble(spec -> ((SegmentSpec.Range) spec.rule()).low())
        .filter(Double::isFinite)
        .findFirst();
  }

  /** Returns all grey values. Reads them once and keeps them. */
  ScalarVolume greyValues() throws VolumeFormatException {
    if (greyValues == null) {
      greyValues = GreyVolumes.read(reader);
    }
    return greyValues;
  }

  private SegmentedVolume readWithGreyValues() throws VolumeFormatException {
    GreyVolumes.WithSegments both = GreyVolumes.readWithSegments(reader, requested);
    greyValues = both.values();
    return both.segments();
  }

  /** Whether the grey values have been read. */
  public boolean hasGreyValues() {
    return greyValues != null;
  }

  /** Reads segments by the given rules. */
  public SegmentedVolume read(List<SegmentSpec> specs) throws VolumeFormatException {
    return SegmentBuilder.read(reader, specs);
  }

  private String emptyLine(String segment) {
    return "palpate: segment "
        + segment
        + " has no voxel: "
        + name
        + ": palpate info prints its values";
  }

  private ValueStatistics.Summary statistics() throws VolumeFormatException {
    ValueStatistics statistics = new ValueStatistics(header());
    reader.readLayers(statistics);
    return statistics.summary();
  }

  /** Whether the values are intensities rather than labels; one pass over them. */
  boolean holdsIntensities() throws VolumeFormatException {
    return isIntensities(statistics());
  }

  /** Whether the user must choose which values are solid. */
  public boolean isIntensities(ValueStatistics.Summary found) {
    return found.labels().isEmpty() || phantom.map(Phantom::grey).orElse(false);
  }

  /** Returns a segment for each label, named as in the file if possible. */
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

  private PalpateException noSegmentChosen(ValueStatistics.Summary found) {
    return PalpateException.wrongUse(
        "no segment is chosen, and the values are intensities from "
            + NumberText.display(found.low())
            + " to "
            + NumberText.display(found.high()),
        name,
        "choose with --segment, for example " + suggestion(found) + reason(found));
  }

  /** Returns arguments for the user to try. */
  public String suggestion(ValueStatistics.Summary found) {
    return new SegmentSuggestion(phantom).arguments(found);
  }

  /** Returns the reason for the suggestion in brackets; empty for a phantom. */
  public String reason(ValueStatistics.Summary found) {
    return new SegmentSuggestion(phantom).reason(found);
  }
}
