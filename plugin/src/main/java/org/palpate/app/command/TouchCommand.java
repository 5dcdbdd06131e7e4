package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.palpate.app.options.AssessOptions;
import org.palpate.app.options.BrushOptions;
import org.palpate.app.options.ChosenCollisionDevice;
import org.palpate.app.options.CollisionDeviceOptions;
import org.palpate.app.options.ContactOptions;
import org.palpate.app.options.DeviceChoice;
import org.palpate.app.options.DeviceOptions;
import org.palpate.app.options.ElasticOptions;
import org.palpate.app.options.FeelOptions;
import org.palpate.app.options.GhostOptions;
import org.palpate.app.options.LinkOptions;
import org.palpate.app.options.MappingOptions;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.RecordOptions;
import org.palpate.app.options.SceneElasticity;
import org.palpate.app.options.SliceOptions;
import org.palpate.app.options.SurfaceOptions;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.EditedVolume;
import org.palpate.app.output.FractureReport;
import org.palpate.app.output.Report;
import org.palpate.app.output.SessionAssessment;
import org.palpate.app.output.ToolReport;
import org.palpate.app.output.WriteFailures;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.ShutdownHook;
import org.palpate.app.process.VersionProvider;
import org.palpate.body.BodyGroups;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.geometry.RigidTransform;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MouseTakeover;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.host.ViewOptions;
import org.palpate.host.placing.FaceFitting;
import org.palpate.io.scene.Ghosts;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.tool.MadeTool;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Runs a live session. */
@Command(
    name = "touch",
    description = {
      "Runs a live session: reads a device and answers with a force a thousand times a second.",
      "It ends on Ctrl-C, after --seconds, or when the device disconnects, and sends zero force"
          + " last.",
      "Bodies that can move are saved every ten seconds; a line at the start says where."
    },
    footer = {
      "",
      "Examples:",
      "  palpate touch --seconds 10 --headless --report r.json",
      "  palpate touch --volume scan.nrrd --segment 'bone=>=1500' --record t.csv",
      "  palpate touch --phantom torus:192 --device simulated:7 --solver paper",
      "  palpate touch --volume labels.nrrd --device hid",
      "  palpate touch --tool sphere:4 --seconds 10 --headless --report r.json",
      "  palpate touch --tool sphere:3 --carve 40 --seconds 10 --headless --export drilled.nrrd",
      "  palpate touch --brush 3,range:300..900 --volume scan.nrrd --segment soft=300..900",
      "  palpate touch --seconds 60 --protect nerve:1 --assess training",
      "  palpate touch --device mouse",
      "  palpate touch --volume scan.nrrd --segment 'bone=>=1500' --slices point",
      "  palpate touch --volume scan.nrrd --segment 'bone=>=1500' --igtl 18944",
      "  palpate touch --scene jaw.json --ghost mirrored.nrrd",
      "  palpate touch --explain",
      "  palpate touch --explain --collision-device opencl"
    })
public final class TouchCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private VolumeOptions volume;
  @Mixin private ContactOptions contact;
  @Mixin private ToolOptions tool;
  @Mixin private ElasticOptions elastic;
  @Mixin private FeelOptions feel;
  @Mixin private BrushOptions brushOptions;
  @Mixin private CollisionDeviceOptions collisionDevice;
  @Mixin private MappingOptions mapping;
  @Mixin private OutputOptions output;
  @Mixin private SliceOptions slices;
  @Mixin private SurfaceOptions surface;
  @Mixin private GhostOptions ghostOptions;
  @Mixin private LinkOptions linkOptions;
  @Mixin private PoseOptions savedPoses;
  @Mixin private RecordOptions record;
  @Mixin private DeviceOptions device;
  @Mixin private AssessOptions assess;

  @Option(names = "--seconds", paramLabel = "S", description = "Ends after S seconds.")
  private Double seconds;

  @Option(
      names = "--upside-down",
      description = "Turns the picture by half a turn, for a file whose axes point the wrong way.")
  private boolean upsideDown;

  @Option(names = "--headless", description = "Opens no window.")
  private boolean headless;

  @Option(
      names = "--export",
      paramLabel = "FILE",
      description =
          "Writes the segments as the session left them: .nrrd, .nii, .nii.gz, .tif or .dcm.")
  private Path exportFile;

  @Option(
      names = "--explain",
      description =
          "Explains what real time needs and what this JVM and this system grant, then ends. With"
              + " --collision-device opencl it also measures when that device pays.")
  private boolean explain;

  private PrintWriter out;
  private Optional<SessionLink> link = Optional.empty();
  private WriteFailures failures;
  private Optional<SessionView> shownView = Optional.empty();
  private Optional<SessionAutosave> autosave = Optional.empty();
  private Optional<SessionAssessment> assessment = Optional.empty();
  private ChosenCollisionDevice judge;
  private Optional<SegmentedVolume> ghosts = Optional.empty();

  @Override
  public Integer call() throws IOException {
    out = spec.commandLine().getOut();
    if (explain) {
      collisionDevice.check(true);
      new RealtimeExplanation(out).print();
      collisionDevice.explain(out, spec.commandLine().getErr());
      return 0;
    }
    failures = new WriteFailures(spec.commandLine().getErr());
    device.check();
    NumberRange.seconds().checkGiven(seconds);
    mapping.takeFrom(volume);
    checkOptionCombination();
    ghostOptions.check(headless, volume.isPlaced());
    volume.refuseSpacing();
    tool.takeFrom(volume, spec.commandLine().getParseResult());
    contact.takeFrom(volume, spec.commandLine().getParseResult());
    contact.checkNeedle(tool.isNeedle(), spec.commandLine().getParseResult());
    elastic.check(volume, tool);
    surface.checkDeformed(elastic);
    record.check(elastic.isWanted());
    tool.checkOthers(spec.commandLine().getParseResult());
    feel.check(tool.isRigid(), contact);
    feel.checkFit(volume.isPlaced());
    brushOptions.check(tool.isRigid(), volume.isPlaced());
    collisionDevice.check(tool.isRigid());
    ShutdownHook.endQuietly();
    try {
      return touch();
    } finally {
      ShutdownHook.discardUnfinishedFiles();
    }
  }

  private int touch() throws IOException {
    if (hasWindow()) {
      GraphicsDriver.prepare();
    }
    Optional<InetSocketAddress> address = linkOptions.address();
    VolumeSource source = VolumeSource.open(volume);
    try (SessionLink opened =
        address.isEmpty() ? null : new SessionLink(address.get(), record.file().isPresent(), out)) {
      link = Optional.ofNullable(opened);
      return touchInTurn(source);
    }
  }

  /** Touches a volume and then each one that a client sends. */
  private int touchInTurn(VolumeSource first) throws IOException {
    VolumeSource source = first;
    int exitCode = touch(source);
    Optional<ReceivedVolume> next = link.flatMap(SessionLink::takeReceived);
    while (next.isPresent()) {
      VolumeSource received = VolumeSource.of(next.get(), volume);
      try {
        exitCode = touch(received);
        source = received;
      } catch (PalpateException e) {
        if (e.exitCode() != PalpateException.WRONG_USE) {
          throw e;
        }
        out.println("OpenIGTLink: the image is not touched: " + e.getMessage());
        exitCode = touch(source);
      }
      next = link.flatMap(SessionLink::takeReceived);
    }
    return exitCode;
  }

  private int touch(VolumeSource source) throws IOException {
    try (ChosenCollisionDevice opened = collisionDevice.open(spec.commandLine().getErr())) {
      judge = opened;
      return touchOnce(source);
    }
  }

  private int touchOnce(VolumeSource source) throws IOException {
    ContactSettings settings = contact.settings();
    DeviceChoice choice = mapping.applyTo(device.choice(), source.header().coordinateSystem());
    List<Path> inputs = new ArrayList<>(source.files());
    inputs.addAll(choice.files());
    inputs.addAll(feel.files());
    inputs.addAll(readGhosts(source));
    Optional<MadeTool> made = tool.isRigid() ? Optional.of(tool.make(source)) : Optional.empty();
    made.ifPresent(each -> inputs.addAll(each.files()));
    Report report = new Report("touch", output.report(), inputs);
    Optional<Path> export = EditedVolume.checkedExport(exportFile, inputs);
    FragmentExport bodies = savedPoses.export(exportFile, source, elastic.isWanted());
    List<Path> targets =
        new ArrayList<>(bodies.checked(inputs, source.isScene() && !elastic.isWanted()));
    if (changesVoxels()) {
      source.placed().ifPresent(bodies::requireCutVoxels);
    }
    export.ifPresent(targets::add);
    targets.addAll(SessionRecording.checked(record.file(), inputs));
    checkTargets(targets, inputs);
    printStart(source, choice, made.map(ToolReport::line).orElse("solver " + settings.solver()));
    made.ifPresent(each -> each.notes().forEach(out::println));
    SegmentedVolume segments =
        contact.segments(source, spec.commandLine().getErr(), feel.needsGrey());
    ContactScene contactScene =
        contact.scene(source, segments, feel.settings(source, segments, tool.massOfHeld()));
    SessionScene scene = scene(contactScene, source, made);
    assessment = assessment(contactScene, made.isPresent());
    EditedVolume edited =
        new EditedVolume(segments, source.header().coordinateSystem(), export, changesVoxels());
    HandTarget target = scene.handTarget();
    LoopSettings loop = device.loop();
    try (HapticDevice opened = open(choice, source, scene, target, loop.periodNanos())) {
      scene.notes(opened.specification()).forEach(out::println);
      device.notes(opened.specification()).forEach(out::println);
      autosave = autosave(source, bodies.writesPoses() || export.isPresent());
      Optional<ViewOptions> view = view(source, scene.contactScene());
      WorldAxes axes = RenderCommand.axes(source.header().coordinateSystem());
      Optional<BrushOptions.Brush> brush =
          brushOptions.brush(source, scene.contactScene(), made.map(MadeTool::tool));
      TouchReport measured = run(scene, opened, choice, loop, view, axes, brush);
      measured.print(out);
      if (report.isWanted()) {
        report.putVolume(source, segments.segments());
      }
      measured.putInto(report);
      scene.putInto(report, measured, judge);
      if (changesVoxels()) {
        report.put("carved", edited.carvedMm3()).put("added", edited.addedMm3());
      }
      if (source.placed().isPresent() || bodies.writesPoses()) {
        finish(source, scene, bodies, report, measured);
      } else {
        edited.write(failures, out);
        report.write();
      }
      assessment.ifPresent(files -> files.write(report.fields(), failures));
      return Math.max(measured.exitCode(), failures.exitCode());
    }
  }

  private Optional<SessionAutosave> autosave(VolumeSource source, boolean writesResult)
      throws IOException {
    PrintWriter err = spec.commandLine().getErr();
    return SessionAutosave.of(source, savedPoses.scene(), changesVoxels(), writesResult, out, err);
  }

  /** Reads the ghosts, and returns their files. */
  private List<Path> readGhosts(VolumeSource source) throws VolumeFormatException {
    Optional<Ghosts> read =
        ghostOptions.read(source.header().coordinateSystem(), spec.commandLine().getErr());
    ghosts = read.map(Ghosts::segments);
    return read.map(Ghosts::files).orElse(List.of());
  }

  private void checkTargets(List<Path> first, List<Path> inputs) {
    List<Path> targets = new ArrayList<>(first);
    output.report().ifPresent(targets::add);
    assess.check(inputs);
    targets.addAll(assess.targets());
    OutputPaths.checkDistinct(targets);
  }

  private Optional<SessionAssessment> assessment(ContactScene scene, boolean isRigid) {
    return assess.folder().map(folder -> new SessionAssessment(folder, scene, isRigid));
  }

  /** Prints, reports and writes what the session left of placed or elastic bodies. */
  private void finish(
      VolumeSource source,
      SessionScene scene,
      FragmentExport bodies,
      Report report,
      TouchReport measured) {
    PlacedVolume left = scene.left(source);
    if (source.placed().isPresent()) {
      FractureReport readings = new FractureReport(left, ghosts);
      readings.lines().forEach(out::println);
      report.put("fracture", readings.field());
    }
    report.write();
    SceneElasticity elasticity = elastic.elasticity(scene.volume());
    Optional<BodyGroups> groups = autosave.map(SessionAutosave::groups);
    failures.attempt(
        exportFile, () -> bodies.write(left, groups, elasticity).forEach(out::println));
    autosave.ifPresent(
        saved -> saved.end(left, measured.endedInOrder(), measured.isByHand(), failures));
  }

  /** Opens the device; the mouse may take a simulated hand over if there is a window. */
  private HapticDevice open(
      DeviceChoice choice,
      VolumeSource source,
      SessionScene scene,
      HandTarget target,
      long periodNanos)
      throws IOException {
    boolean reduces =
        choice.device().isSimulated()
            && source.placed().filter(PlacedVolume::isDisplaced).isPresent();
    if (reduces) {
      out.println("planning how a simulated hand puts the fragments back ...");
      out.flush();
    }
    HapticDevice opened =
        reduces
            ? scene.reducingHand(choice.device().seed(), periodNanos)
            : choice.open(target, source.header().coordinateSystem(), periodNanos, tool.isRigid());
    return hasWindow() && choice.device().isSimulated()
        ? new MouseTakeover(opened, target, periodNanos)
        : opened;
  }

  /** Rejects options that would otherwise be ignored silently. */
  private void checkOptionCombination() {
    surface.check();
    WindowNeeds needs = new WindowNeeds(headless);
    needs.check(spec.commandLine().getParseResult());
    needs.check("--axes view", mapping.asksForView());
    needs.check("--device mouse", device.isMouse());
  }

  private void printStart(VolumeSource source, DeviceChoice choice, String held) {
    String version = VersionProvider.version();
    out.println(
        String.format("palpate %s: %s, device %s, %s", version, source.name(), choice, held));
    if (!headless) {
      GraphicsDriver.missingDisplay()
          .ifPresent(why -> out.println(why + ": goes on without a window"));
    }
    out.flush();
  }

  private SessionScene scene(
      ContactScene contactScene, VolumeSource source, Optional<MadeTool> made) throws IOException {
    return SessionScene.of(contactScene, tool, made, judge.device())
        .withFit(
            feel.faceFit(
                contactScene.volume(),
                source.header().coordinateSystem(),
                spec.commandLine().getErr()));
  }

  private TouchReport run(
      SessionScene scene,
      HapticDevice opened,
      DeviceChoice choice,
      LoopSettings loop,
      Optional<ViewOptions> viewOptions,
      WorldAxes axes,
      Optional<BrushOptions.Brush> brush)
      throws IOException {
    try (SessionRecording recording =
            new SessionRecording(record, scene.volume().segments(), failures);
        RealtimeThread realtime = RealtimeThread.recommended(loop.periodNanos());
        TouchSession session =
            scene.newSession(
                opened,
                SessionSettings.standard()
                    .withDefaultStiffness(choice.defaultStiffness(opened, scene.contactScene()))
                    .withLoop(loop.with(realtime, realtime))
                    .withRecorder(recording.recorder())
                    .withElastic(elastic.bodies(scene.volume(), contact.solver()))
                    .withEditRecorder(recording.editRecorder())
                    .withBodyRecorder(recording.bodyRecorder())
                    .withFieldRecorder(recording.fieldRecorder()))) {
      assessment.ifPresent(files -> session.observe(files.live()));
      Supplier<List<RigidTransform>> poses =
          () -> shownView.map(SessionView::bodyPoses).orElseGet(session::bodyPoses);
      Optional<FaceFitting> fitting = scene.fitting(session, feel.fits());
      Optional<SessionBrush> painter =
          brush.map(held -> new SessionBrush(held, session, scene.volume(), scene.tool()));
      Runnable check =
          () -> {
            recording.check();
            judge.reportFailure();
            assessment.ifPresent(SessionAssessment::drain);
            painter.ifPresent(SessionBrush::tick);
            fitting.ifPresent(thread -> thread.see(poses.get()));
          };
      SessionSupervisor supervisor =
          new SessionSupervisor(session, Optional.ofNullable(seconds), check, out);
      ConsoleViewListener listener = new ConsoleViewListener(out, supervisor::stop);
      Optional<SessionView> view =
          viewOptions.map(
              options -> new SessionView(session, scene.volume(), axes, opened, listener, options));
      view.ifPresent(shown -> listener.serve(shown, session, scene.volume(), axes));
      view.ifPresent(shown -> painter.ifPresent(held -> held.addKeys(listener, shown)));
      view.ifPresent(supervisor::show);
      shownView = view;
      link.ifPresent(
          server ->
              server.stream(
                  session,
                  axes,
                  () -> view.map(SessionView::landmarks).orElse(List.of()),
                  supervisor::stop));
      LoopEnd end =
          supervisor.run(
              view.flatMap(shown -> scene.readings(session, shown, listener, ghosts)),
              fitting,
              autosave.flatMap(saved -> saved.begin(session)));
      link.ifPresent(SessionLink::pause);
      recording.finish();
      return new TouchReport(session, end, choice, opened, supervisor, view, realtime.throttled());
    }
  }

  /** Returns why the threshold must not change; empty if it may. */
  private String thresholdRefusal() {
    if (record.file().isPresent()) {
      return "the threshold stays while --record records: a replay has one threshold";
    }
    return changesVoxels() || exportFile != null || elastic.isWanted()
        ? "the threshold stays with --carve, --brush, --elastic and --export: they are about the"
            + " voxels of one threshold"
        : "";
  }

  private boolean changesVoxels() {
    return contact.cuts() || brushOptions.isGiven();
  }

  private boolean hasWindow() {
    return !headless && GraphicsDriver.hasDisplay();
  }

  /** Returns the options of the window; empty if there is none. */
  private Optional<ViewOptions> view(VolumeSource source, ContactScene scene)
      throws VolumeFormatException {
    if (!hasWindow()) {
      return Optional.empty();
    }
    Optional<MovableSlices.Start> planes = slices.start(source);
    return Optional.of(
        new ViewOptions(
            surface.greys(source, source.hasGreyValues()),
            planes,
            Optional.empty(),
            upsideDown,
            tool.isRigid()
                ? Optional.empty()
                : SliceOptions.threshold(source)
                    .map(start -> new ViewOptions.Threshold(scene, start, thresholdRefusal())),
            mapping.followsView(),
            surface.clip(),
            surface.deformed(),
            ghosts));
  }
}
