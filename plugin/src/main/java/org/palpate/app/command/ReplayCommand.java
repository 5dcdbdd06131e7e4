package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.palpate.app.options.AssessOptions;
import org.palpate.app.options.ChosenCollisionDevice;
import org.palpate.app.options.CollisionDeviceOptions;
import org.palpate.app.options.ContactOptions;
import org.palpate.app.options.ElasticOptions;
import org.palpate.app.options.FeelOptions;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.EditedVolume;
import org.palpate.app.output.ElasticFields;
import org.palpate.app.output.FaultFields;
import org.palpate.app.output.MassFields;
import org.palpate.app.output.NeedleFields;
import org.palpate.app.output.ProtectedFields;
import org.palpate.app.output.ReplayTables;
import org.palpate.app.output.Report;
import org.palpate.app.output.SessionAssessment;
import org.palpate.app.output.ToolReport;
import org.palpate.app.output.ToolTables;
import org.palpate.app.output.WorkFields;
import org.palpate.app.output.WriteFailures;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditSchedule;
import org.palpate.frame.FrameStatistics;
import org.palpate.host.ContactScene;
import org.palpate.host.ReplayRun;
import org.palpate.host.ReplayTiming;
import org.palpate.host.SolverKind;
import org.palpate.host.ToolReplay;
import org.palpate.host.ToolScene;
import org.palpate.io.table.BodyPose;
import org.palpate.io.table.FieldsCsv;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.tool.MadeTool;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Runs the frames of a recorded trajectory without a device and without a clock. */
@Command(
    name = "replay",
    description = "Runs the frames of a recorded trajectory offline, with bit-identical results.",
    footer = {
      "",
      "Examples:",
      "  palpate replay --trajectory t.csv --out frames.csv",
      "  palpate replay --volume scan.nrrd --segment 'bone=>=1500' --trajectory t.csv \\",
      "    --out frames.csv --legs legs.csv --solver guarded --report r.json",
      "  palpate replay --tool sphere:4 --trajectory t.csv --out frames.csv --legs legs.csv",
      "  palpate replay --tool sphere:3 --trajectory t.csv --edits t.edits.csv --export cut.nrrd",
      "  palpate replay --tool sphere:4 --trajectory t.csv --poses poses.csv --legs legs.csv",
      "  palpate replay --tool sphere:4 --trajectory t.csv --collision-device opencl",
      "  palpate replay --tool sphere:4 --trajectory t.csv --assess training",
      "  palpate replay --phantom block:64 --elastic block=young:20e3 --fixed base \\",
      "    --trajectory t.csv --out frames.csv --legs legs.csv",
      "  palpate replay --phantom sphere:192 --coordinates grid --trajectory t.csv --repeat 12 \\",
      "    --report time.json"
    })
public final class ReplayCommand implements Callable<Integer> {
  /** The coordinates of a trajectory's positions. */
  enum Coordinates {
    world,
    grid
  }

  /** The first passes are not counted. */
  private static final NumberRange REPEAT =
      new NumberRange(
          "--repeat",
          "the number of passes",
          ReplayTiming.UNCOUNTED_PASSES + 1,
          1_000_000,
          "",
          "12");

  private static final double MS_PER_SECOND = 1e3;

  @Spec private CommandSpec spec;
  @Mixin private VolumeOptions volume;
  @Mixin private ContactOptions contact;
  @Mixin private ToolOptions tool;
  @Mixin private ElasticOptions elastic;
  @Mixin private FeelOptions feel;
  @Mixin private AssessOptions assess;
  @Mixin private CollisionDeviceOptions collisionDevice;
  @Mixin private OutputOptions output;
  @Mixin private RecordedTables recorded;

  @Option(
      names = "--coordinates",
      paramLabel = "world|grid",
      defaultValue = "world",
      description =
          "Coordinates of the positions: world mm or, for a point, grid. Default:"
              + " ${DEFAULT-VALUE}.")
  private Coordinates coordinates;

  @Option(
      names = "--out",
      paramLabel = "FRAMES.csv",
      description =
          "Writes one row for each frame: device, interaction point or tool pose, force, contact"
              + " and path; for a tool also orientations and torque.")
  private Path framesFile;

  @Option(
      names = "--legs",
      paramLabel = "LEGS.csv",
      description =
          "Writes every leg of the interaction point, or of each point of a tool, in grid"
              + " coordinates.")
  private Path legsFile;

  @Option(
      names = "--legs-every",
      paramLabel = "N",
      description = "Of a tool, writes the legs of those points alone whose index N divides.")
  private Integer legsEvery;

  @Option(
      names = "--legs-frames",
      paramLabel = "A..B",
      description = "Of a tool, writes the legs of frames A to B alone, counted from 0.")
  private String legsFrames;

  @Option(
      names = "--export",
      paramLabel = "FILE",
      description =
          "Writes the segments as the replay left them: .nrrd, .nii, .nii.gz, .tif or .dcm.")
  private Path exportFile;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      description = "Replays N times, at least 3, and reports the time of solver and force.")
  private Integer repeat;

  private WriteFailures failures;
  private Optional<SessionAssessment> assessment = Optional.empty();

  @Override
  public Integer call() throws IOException {
    failures = new WriteFailures(spec.commandLine().getErr());
    REPEAT.checkGiven(repeat);
    volume.refuseSpacing();
    tool.takeFrom(volume, spec.commandLine().getParseResult());
    contact.takeFrom(volume, spec.commandLine().getParseResult());
    contact.checkNeedle(tool.isNeedle(), spec.commandLine().getParseResult());
    contact.settings();
    elastic.check(volume, tool);
    requireRepeatable();
    boolean rigid = tool.isRigid() || recorded.movesBodies();
    tool.checkOthers(spec.commandLine().getParseResult(), rigid);
    feel.check(rigid, contact);
    feel.checkFit(false);
    collisionDevice.check(rigid);
    return rigid ? replayTool() : replayPoint();
  }

  /** Refuses to time passes if the first one moves bodies or changes voxels. */
  private void requireRepeatable() {
    Optional<String> changing =
        Stream.of("--poses", "--edits", "--carve", "--elastic")
            .filter(spec.commandLine().getParseResult()::hasMatchedOption)
            .findFirst();
    if (repeat != null && changing.isPresent()) {
      throw PalpateException.wrongUse(
          "a pass would not begin where the last one did",
          "--repeat with " + changing.get(),
          "leave one of them out");
    }
  }

  private int replayPoint() throws IOException {
    boolean world = coordinates == Coordinates.world;
    VolumeSource source = VolumeSource.open(volume);
    List<Path> inputs = new ArrayList<>(source.files());
    inputs.addAll(recorded.files());
    inputs.addAll(feel.files());
    Report report = new Report("replay", output.report(), inputs);
    Optional<Path> export = checkedExport(inputs);
    ReplayTables tables =
        ReplayTables.checked(framesFile, legsFile, output.report(), inputs, failures);
    Trajectory trajectory = recorded.trajectory();
    SegmentedVolume segments =
        contact.segments(source, spec.commandLine().getErr(), feel.needsGrey());
    EditSchedule edits = recorded.edits(segments);
    EditedVolume edited =
        new EditedVolume(segments, source.header().coordinateSystem(), export, changesVoxels());
    ContactScene scene =
        contact.scene(source, segments, feel.settings(source, segments, tool.massOfHeld()));
    ReplayRun plain =
        world ? ReplayRun.inWorld(scene, trajectory) : ReplayRun.inGrid(scene, trajectory);
    assessment = assessment(scene, false);
    ReplayRun observed =
        plain.withEdits(edits).withObserver(assessment.map(SessionAssessment::replayed));
    ReplayRun replay = deformed(observed, segments);
    ReplayRun.Result result =
        run(recorded.isRaw() ? replay.inRawMode() : replay, trajectory, tables);
    print(result.statistics());
    if (report.isWanted()) {
      report.putVolume(source, segments.segments());
    }
    putResult(report, result);
    result.elastic().ifPresent(body -> report.put("elastic", ElasticFields.of(body)));
    if (repeat != null) {
      putTime(new ReplayTiming(scene, trajectory, world).run(repeat), report);
    }
    ProtectedFields.put(report, scene, frame -> trajectory.timeMs((int) frame) / MS_PER_SECOND);
    finish(report, edited, segments);
    return failures.exitCode();
  }

  private ReplayRun deformed(ReplayRun replay, SegmentedVolume segments) throws IOException {
    SolverKind solver = contact.solver();
    Optional<Path> updates = recorded.fieldsFile();
    return updates.isEmpty()
        ? elastic.deform(replay, segments, solver)
        : elastic.deform(replay, segments, solver, updates.get(), FieldsCsv.read(updates.get()));
  }

  /** Refuses what a rigid tool, or bodies that move, do not have. */
  private void checkToolOptions() {
    if (coordinates == Coordinates.grid) {
      throw PalpateException.wrongUse(
          "a tool moves in the world",
          recorded.movesBodies()
              ? "--coordinates grid with --poses"
              : "--coordinates grid with --tool",
          "give a trajectory in world mm");
    }
    if (elastic.isWanted()) {
      throw PalpateException.wrongUse(
          "elastic bodies and those beside them stand where they rest",
          "--scene with --poses",
          "leave one of them out");
    }
    if (feel.hasGreyMaterials() && recorded.movesBodies()) {
      throw PalpateException.wrongUse(
          "grey values are those of bodies that stand still",
          "--material-from-grey with --poses",
          "leave one of them out");
    }
    if (contact.protects() && recorded.movesBodies()) {
      throw PalpateException.wrongUse(
          "margins are for segments that stand still",
          "--protect with --poses",
          "leave one of them out");
    }
  }

  private int replayTool() throws IOException {
    checkToolOptions();
    ToolTables.LegSelection selection = ToolTables.LegSelection.parse(legsEvery, legsFrames);
    VolumeSource source = VolumeSource.open(volume);
    MadeTool made = tool.make(source);
    List<Path> inputs = new ArrayList<>(source.files());
    inputs.addAll(recorded.files());
    inputs.addAll(feel.files());
    inputs.addAll(made.files());
    Report report = new Report("replay", output.report(), inputs);
    Optional<Path> export = checkedExport(inputs);
    ReplayTables tables =
        ReplayTables.checked(framesFile, legsFile, output.report(), inputs, failures);
    Trajectory trajectory = recorded.trajectory();
    made.notes().forEach(spec.commandLine().getErr()::println);
    SegmentedVolume segments =
        contact.segments(source, spec.commandLine().getErr(), feel.needsGrey());
    EditSchedule edits = recorded.edits(segments);
    EditedVolume edited =
        new EditedVolume(segments, source.header().coordinateSystem(), export, changesVoxels());
    List<BodyPose> poses = recorded.poses(segments);
    try (ChosenCollisionDevice device = collisionDevice.open(spec.commandLine().getErr())) {
      ToolScene scene =
          tool.scene(
              contact.scene(source, segments, feel.settings(source, segments, tool.massOfHeld())),
              made,
              ToolReplay.movable(poses),
              device.device());
      recorded.requireNothingAddedToMovable(scene.bodies(), edits);
      assessment = assessment(scene.contactScene(), true);
      ToolReplay replay =
          new ToolReplay(
              scene,
              trajectory,
              recorded.isRaw(),
              edits,
              poses,
              assessment.map(SessionAssessment::replayed));
      ToolReplay.Result result = run(replay, scene, trajectory, tables, selection);
      ToolReport measured = new ToolReport(made, tool.massKg());
      measured.print(result, spec.commandLine().getOut());
      if (report.isWanted()) {
        report.putVolume(source, segments.segments());
      }
      measured.putInto(report, result);
      if (repeat != null) {
        putTime(new ToolReplay(scene, trajectory, recorded.isRaw()).time(repeat), report);
      }
      report.put("collision_device", device.fields());
      NeedleFields.put(report, scene);
      MassFields.put(report, scene);
      ProtectedFields.put(
          report, scene.contactScene(), frame -> trajectory.timeMs((int) frame) / MS_PER_SECOND);
      finish(report, edited, segments.hasOneGrid() ? segments : scene.present());
    }
    return failures.exitCode();
  }

  private Optional<SessionAssessment> assessment(ContactScene scene, boolean isRigid) {
    return assess.folder().map(folder -> new SessionAssessment(folder, scene, isRigid));
  }

  private Optional<Path> checkedExport(List<Path> inputs) throws VolumeFormatException {
    Optional<Path> export = EditedVolume.checkedExport(exportFile, inputs);
    assess.check(inputs);
    OutputPaths.checkDistinct(
        Stream.concat(
                Stream.of(exportFile, framesFile, legsFile, output.report().orElse(null))
                    .filter(Objects::nonNull),
                assess.targets().stream())
            .toList());
    return export;
  }

  private boolean changesVoxels() {
    return contact.cuts() || recorded.editsVoxels();
  }

  private void finish(Report report, EditedVolume edited, SegmentedVolume left) {
    if (changesVoxels()) {
      report.put("carved", edited.carvedMm3()).put("added", edited.addedMm3());
    }
    edited.write(left, failures, spec.commandLine().getOut());
    report.write();
    assessment.ifPresent(files -> files.write(report.fields(), failures));
  }

  private static ToolReplay.Result run(
      ToolReplay replay,
      ToolScene scene,
      Trajectory trajectory,
      ReplayTables tables,
      ToolTables.LegSelection selection)
      throws IOException {
    try (tables) {
      ToolTables rows = tables.openForTool(trajectory, scene, selection);
      ToolReplay.Result result = replay.run(rows);
      tables.commit();
      return result;
    }
  }

  private static ReplayRun.Result run(ReplayRun replay, Trajectory trajectory, ReplayTables tables)
      throws IOException {
    try (tables) {
      tables.open(trajectory);
      ReplayRun.Result result = replay.run(tables);
      tables.commit();
      return result;
    }
  }

  private void print(FrameStatistics statistics) {
    PrintWriter out = spec.commandLine().getOut();
    out.println(
        String.format(
            Locale.ROOT,
            "%,d frames, %,d in contact, set free %,d times, largest force %.3f N (%s, %s)",
            statistics.frames(),
            statistics.contactFrames(),
            statistics.freed(),
            statistics.maxForceNewton(),
            contact.solver(),
            contact.collision()));
  }

  private void putResult(Report report, ReplayRun.Result result) {
    FrameStatistics statistics = result.statistics();
    report
        .put("frames", statistics.frames())
        .put("contact_frames", statistics.contactFrames())
        .put("freed", statistics.freed())
        .put("max_force_n", statistics.maxForceNewton())
        .put("solver", contact.solver().toString())
        .put("collision", contact.collision().toString())
        .put("work", WorkFields.of(result.work()))
        .put("skipped", statistics.skipped())
        .put("faults", FaultFields.of(statistics.faults()));
    result.mass().ifPresent(body -> report.put("mass", MassFields.of(body)));
  }

  private void putTime(ReplayTiming.NanosPerFrame nanos, Report report) {
    Map<String, Object> field = new LinkedHashMap<>();
    field.put("min", nanos.min());
    field.put("median", nanos.median());
    field.put("max", nanos.max());
    report.put("ns_per_frame", field);
    spec.commandLine()
        .getOut()
        .println(
            String.format(
                Locale.ROOT,
                "%.0f ns a frame (median of %d passes; %.0f to %.0f)",
                nanos.median(),
                repeat - ReplayTiming.UNCOUNTED_PASSES,
                nanos.min(),
                nanos.max()));
  }
}
