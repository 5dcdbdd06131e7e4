package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.palpate.app.options.FragmentOptions;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.ReshapeOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.FractureReport;
import org.palpate.app.output.Report;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.OrientationText;
import org.palpate.io.VolumeWriter;
import org.palpate.io.file.NumberText;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.label.ValueStatistics;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FragmentScatter;
import org.palpate.volume.fracture.Fragments;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Prints the properties of a volume and exports volumes. */
@Command(
    name = "info",
    description = "Prints the size, spacing, type, values, segments and memory need of a volume.",
    footer = {
      "",
      "Examples:",
      "  palpate info --volume scan.nrrd",
      "  palpate info --volume scan.nrrd --segment 'bone=>=1500' --report info.json",
      "  palpate info --volume scan.nrrd --segment 'bone=>=1500' --export bone.nii.gz",
      "  palpate info --volume labels.nii.gz --export segments.dcm",
      "  palpate info --volume scan.nii.gz --export for-imagej.tif",
      "  palpate info --volume scan.nrrd --segment 'jaw=>=1500' --fracture 4 --export parts.nrrd",
      "  palpate info --volume jaw.nrrd --fracture 4 --export parts.nrrd --save-scene jaw.json",
      "  palpate info --scene jaw.json --fit 1 --save-scene proposed.json",
      "  palpate info --volume parts.nrrd --split components:500 --export parts2.nrrd",
      "  palpate info --volume scan.nrrd --crop 10..99,0..63,5..40 --resample 1 --export s.nrrd",
      "  palpate info --volume slices.raw --raw 256x256x113:u16be:1,1,2",
      "  palpate info --phantom torus:192"
    })
public final class InfoCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private VolumeOptions volume;
  @Mixin private OutputOptions output;
  @Mixin private FragmentOptions fragments;
  @Mixin private ReshapeOptions reshape;
  @Mixin private PoseOptions savedPoses;
  @Mixin private ReassemblyOption reassembly;

  @Option(
      names = "--export",
      paramLabel = "FILE",
      description = {
        "Writes the volume to a .nrrd, .nii, .nii.gz or .tif file (the last as ImageJ does); with"
            + " --segment, the segments as labels. A .dcm file is a DICOM segmentation of the"
            + " segments."
      })
  private Path export;

  private PrintWriter out;

  @Override
  public Integer call() throws IOException {
    out = spec.commandLine().getOut();
    fragments.checkText();
    reassembly.checkGap();
    VolumeSource source = VolumeSource.open(volume);
    reshape.check(source.reader(), volume.spacing());
    Report report = new Report("info", output.report(), source.files());
    checkExport(source);
    fragments.check(export);
    reassembly.check(source.placed().isPresent());
    printHeader(source);
    out.flush();
    ValueStatistics statistics = new ValueStatistics(source.header());
    source.reader().readLayers(statistics);
    ValueStatistics.Summary found = statistics.summary();
    printValues(found);
    List<Segment> segments = segments(source, found);
    source.placed().ifPresent(bodies -> printOwnGrids(bodies.rest()));
    printSegments("segment", segments);
    printSegments("fill", source.fills());
    Optional<FractureReport> readings = source.placed().map(FractureReport::new);
    readings.ifPresent(this::printReadings);
    Optional<PlacedVolume> proposed =
        reassembly.propose(source.placed(), words -> line("proposal", words));
    proposed.map(FractureReport::new).ifPresent(this::printProposed);
    if (source.requested().isEmpty()) {
      source.emptySegments(found.labels()).forEach(empty -> line("segment", empty + ": no voxel"));
    }
    if (fragments.isWanted()) {
      exportPlaced(broken(source, segments));
    } else if (fragmentExport().writesPoses()) {
      exportPlaced(proposed.orElseGet(source.placed()::get));
    } else if (export != null) {
      export(source, segments, source.isIntensities(found));
    }
    if (source.requested().isEmpty() && source.isIntensities(found)) {
      line(
          "segments",
          "none chosen; for example " + source.suggestion(found) + source.reason(found));
    }
    double bytes = SegmentBuilder.bytesFor(source.header().grid(), segments.size());
    line("memory", NumberText.bytes(bytes) + " for the segments");
    if (report.isWanted()) {
      readings.ifPresent(read -> report.put("fracture", read.field()));
      writeReport(report, source, found, segments, bytes);
    }
    return 0;
  }

  private void checkExport(VolumeSource source) throws IOException {
    boolean isReshaped = reshape.isWanted() || volume.spacing().isPresent();
    if (isReshaped && (export == null || fragments.isWanted() || fragmentExport().writesPoses())) {
      throw PalpateException.wrongUse(
          "only an exported volume is cropped, resampled or mirrored",
          "--crop, --resample or --mirror",
          "add --export FILE, and make fragments of that file in a second step");
    }
    if (fragmentExport().writesPoses() && !fragments.isWanted() && source.placements().isEmpty()) {
      throw PalpateException.wrongUse(
          "the volume has no bodies with poses",
          source.name(),
          "add --fracture or --split, or choose --scene or --phantom fracture");
    }
    boolean haveFiles = source.isScene() && !fragments.isWanted();
    List<Path> targets = new ArrayList<>(fragmentExport().checked(source.files(), haveFiles));
    if (export != null) {
      OutputPaths.checked("--export", export, source.files());
      VolumeWriter.checkName(export);
      targets.add(export);
    }
    output.report().ifPresent(targets::add);
    OutputPaths.checkDistinct(targets);
  }

  /** Makes and prints the fragments. Those of a fracture are displaced if poses are written. */
  private PlacedVolume broken(VolumeSource source, List<Segment> segments) {
    Fragments made = fragments.make(segments, source.header().grid(), source.name());
    printSegments("segment", made.segments().segments());
    line("left out", NumberText.count((double) made.lostVoxels()) + " voxels");
    try {
      List<Pose> poses =
          fragments.isFracture() && fragmentExport().writesPoses()
              ? FragmentScatter.scatter(made, fragments.spec().seed(), false)
              : Collections.nCopies(made.bits().size(), new Pose());
      return PlacedVolume.ofFragments(made, poses, source.header().coordinateSystem());
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(e.getMessage(), e);
    }
  }

  private void printReadings(FractureReport readings) {
    readings.lines().forEach(words -> line("reading", words));
  }

  private void printProposed(FractureReport readings) {
    printReadings(readings);
    if (readings.overlaps()) {
      line(
          "note",
          "touch refuses a scene in which sample points of one body lie inside another; then put"
              + " one of the two back where it was, and place it by hand");
    }
  }

  private FragmentExport fragmentExport() {
    return savedPoses.export(export);
  }

  private void exportPlaced(PlacedVolume bodies) throws IOException {
    fragmentExport().write(bodies).forEach(out::println);
  }

  private static List<Segment> segments(VolumeSource source, ValueStatistics.Summary found)
      throws IOException {
    List<SegmentSpec> specs =
        source.requested().isEmpty() && !source.isIntensities(found)
            ? source.specsOf(found.labels())
            : source.requested();
    return specs.isEmpty() ? List.of() : source.read(specs).segments();
  }

  private void printHeader(VolumeSource source) {
    VolumeHeader header = source.header();
    VoxelGrid grid = header.grid();
    Vec3 spacing = grid.spacingMm();
    line("volume", source.name() + " (" + header.format() + ")");
    line(
        "size",
        String.format(
            Locale.ROOT,
            "%d x %d x %d voxels, %,d in all",
            grid.sizeX(),
            grid.sizeY(),
            grid.sizeZ(),
            grid.voxelCount()));
    line("spacing", triple(spacing.x, spacing.y, spacing.z) + " mm");
    line(
        "extent",
        triple(grid.sizeX() * spacing.x, grid.sizeY() * spacing.y, grid.sizeZ() * spacing.z)
            + " mm");
    line("type", header.type().description());
    line("world", header.coordinateSystem().description());
    OrientationText.describe(header).forEach(words -> line("", words));
    header.notes().forEach(note -> line("note", note));
  }

  private static String triple(double x, double y, double z) {
    return OrientationText.number(x)
        + " x "
        + OrientationText.number(y)
        + " x "
        + OrientationText.number(z);
  }

  private void printValues(ValueStatistics.Summary found) {
    String range = NumberText.display(found.low()) + " to " + NumberText.display(found.high());
    String odd =
        found.notFinite() == 0
            ? ""
            : String.format(Locale.ROOT, ", and %,d that are not numbers", found.notFinite());
    line("values", found.low() <= found.high() ? range + odd : "no value is a number");
  }

  private void printSegments(String what, List<Segment> segments) {
    for (Segment segment : segments) {
      line(
          what,
          String.format(
              Locale.ROOT,
              "%s: %,d voxels, %s",
              segment.name(),
              segment.bits().solidCount(),
              segment.bits().bounds()));
    }
  }

  /** Prints the grid of each body that has one of its own. */
  private void printOwnGrids(SegmentedVolume bodies) {
    for (int n = 0; n < bodies.segments().size(); n++) {
      VoxelGrid own = bodies.grid(n);
      if (!own.equals(bodies.grid())) {
        Vec3 spacing = own.spacingMm();
        line(
            "own grid",
            String.format(
                Locale.ROOT,
                "%s: %d x %d x %d voxels of %s mm, %,d of them solid",
                bodies.segments().get(n).name(),
                own.sizeX(),
                own.sizeY(),
                own.sizeZ(),
                triple(spacing.x, spacing.y, spacing.z),
                bodies.segments().get(n).bits().solidCount()));
      }
    }
  }

  private void export(VolumeSource source, List<Segment> segments, boolean isIntensities)
      throws IOException {
    VolumeHeader header = source.header();
    if (VolumeWriter.isDicom(export) && segments.isEmpty()) {
      throw PalpateException.wrongUse(
          "DICOM is written for segments only, and none is chosen",
          "--export " + export,
          "choose segments with --segment, or name the file .nrrd or .nii.gz");
    }
    boolean isWhole = source.requested().isEmpty() && !VolumeWriter.isDicom(export);
    VolumeReader written =
        isWhole
            ? source.reader()
            : new SegmentsAsLabels(
                new SegmentedVolume(header.grid(), segments), header.coordinateSystem());
    VolumeReader shaped = reshape.applyTo(written, volume.spacing(), !(isWhole && isIntensities));
    out.println(OutputPaths.written(export, VolumeWriter.write(shaped, export)));
  }

  private void line(String what, String text) {
    out.println(String.format(Locale.ROOT, "%-9s %s", what, text));
  }

  private static void writeReport(
      Report report,
      VolumeSource source,
      ValueStatistics.Summary found,
      List<Segment> segments,
      double bytes)
      throws IOException {
    report.putVolume(source, segments);
    VolumeHeader header = source.header();
    report
        .put("format", header.format())
        .put("type", header.type().description())
        .put("value_range", List.of(found.low(), found.high()))
        .put("not_finite", found.notFinite())
        .put("notes", header.notes())
        .put("memory_bytes", (long) bytes)
        .write();
  }
}
