package org.palpate.imagej.session;

import ij.IJ;
import ij.ImageListener;
import ij.ImagePlus;
import ij.plugin.frame.Recorder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.host.ContactScene;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.PlacingKeys;
import org.palpate.imagej.dialog.PlaceOptions;
import org.palpate.imagej.stack.PixelSnapshot;
import org.palpate.imagej.stack.PlacedLabels;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.file.NumberParser;
import org.palpate.io.file.NumberText;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.rigid.RigidScene;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.scene.window.SceneWindow;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.PosedBits;

/**
 * The fragments of a label stack, which a hand takes, moves and puts down. At the end a new label
 * stack shows them where they were left, and the recorder has their poses.
 */
public final class PlacingSession extends HandSession implements ImageListener {
  private static final String MOVE = "org.palpate.imagej.PlaceFragments.move";

  private final StackVolume stack;
  private final List<SegmentRange> ranges;
  private final SegmentedVolume volume;
  private final RealtimeThread realtime = StackRealtime.thread();
  private final TouchSession session;
  private final Optional<SessionView> view;
  private final PlacingAutosave autosave;
  private volatile List<RigidTransform> poses;
  private volatile boolean isImageClosed;

  /**
   * Builds the fragments, opens the device and prepares the session.
   *
   * @throws TouchRefusedException if the stack, the device or an option does not allow a session
   */
  PlacingSession(StackVolume stack, PlaceOptions options) throws TouchRefusedException {
    super(StackGeometry.of(stack.image()), options.seconds());
    this.stack = stack;
    ranges = options.ranges(stack);
    IJ.showStatus("Palpate: making fragments...");
    PixelSnapshot pixels = new PixelSnapshot(stack);
    List<Segment> segments =
        StackSegments.of(stack, pixels::slice, ranges, k -> IJ.showProgress(k + 1, stack.slices()));
    volume = new SegmentedVolume(StackGeometry.of(stack.image()).grid(), segments);
    PlacingAutosave.Start start = start(options);
    ContactScene scene =
        new ContactScene(volume, start.placements(), options.contactSettings(), Optional.empty());
    stack.logWarning(scene.settings().solver());
    poses = Placement.transforms(start.placements());
    LoopSettings loop = LoopSettings.ofRate(StackSession.RATE_HZ).with(realtime, realtime);
    StackDevice device =
        StackDevice.open(options.device(), scene, options.workspace(), loop.periodNanos());
    session =
        new TouchSession(
            tool(scene),
            device.device(),
            SessionSettings.standard()
                .withDefaultStiffness(device.defaultNewtonPerMm())
                .withLoop(loop));
    view =
        options.view() && GraphicsDriver.hasDisplay()
            ? Optional.of(
                new SessionView(
                    session, volume, WorldAxes.UNKNOWN, device.device(), new Listener()))
            : Optional.empty();
    ToolFrame frame = session.toolFrame().orElseThrow();
    start.groups().ifPresent(frame::requestGroups);
    autosave = new PlacingAutosave(stack, placed(start.placements()), frame);
    ImagePlus.addImageListener(this);
  }

  /** Returns where the fragments begin: in the stack, or where an earlier session left them. */
  private PlacingAutosave.Start start(PlaceOptions options) throws TouchRefusedException {
    List<Placement> atRest = placements(options.fixed());
    return options.resume()
        ? PlacingAutosave.resume(stack, volume, atRest)
        : new PlacingAutosave.Start(atRest, Optional.empty());
  }

  private PlacedVolume placed(List<Placement> placements) {
    return new PlacedVolume(
        volume, placements, CoordinateSystem.UNKNOWN, List.of(), List.of(), Optional.empty());
  }

  private List<Placement> placements(int fixedLabel) throws TouchRefusedException {
    List<Placement> placements = new ArrayList<>();
    int fixed = fixedLabel == 0 ? largest() : indexOf(fixedLabel);
    for (int n = 0; n < ranges.size(); n++) {
      placements.add(new Placement(n == fixed ? Mobility.FIXED : Mobility.MOVABLE, new Pose()));
    }
    return placements;
  }

  private int largest() {
    int largest = 0;
    for (int n = 0; n < ranges.size(); n++) {
      largest = voxels(n) > voxels(largest) ? n : largest;
    }
    return largest;
  }

  private long voxels(int n) {
    return volume.segments().get(n).bits().solidCount();
  }

  private int indexOf(int label) throws TouchRefusedException {
    for (int n = 0; n < ranges.size(); n++) {
      if (ranges.get(n).lower() == label) {
        return n;
      }
    }
    throw new TouchRefusedException("The stack has no label " + label + ".");
  }

  /** Returns a point among the fragments. */
  private static ToolScene tool(ContactScene scene) throws TouchRefusedException {
    try {
      return ToolScene.ofPoint(scene);
    } catch (RigidScene.BodiesOverlapException e) {
      throw new TouchRefusedException("Two labels overlap: " + e.getMessage());
    }
  }

  @Override
  TouchSession session() {
    return session;
  }

  @Override
  public Optional<SessionView> view() {
    return view;
  }

  @Override
  LoopEnd run() throws TouchRefusedException {
    autosave.start();
    return super.run();
  }

  @Override
  void tick() {
    if (session.status().frames() > 0) {
      poses = view.map(SessionView::bodyPoses).orElseGet(session::bodyPoses);
    }
  }

  @Override
  boolean isImageClosed() {
    return isImageClosed;
  }

  @Override
  public void imageOpened(ImagePlus image) {}

  @Override
  public void imageUpdated(ImagePlus image) {}

  @Override
  public void imageClosed(ImagePlus image) {
    if (image == stack.image()) {
      isImageClosed = true;
      wake();
    }
  }

  /** Shows the result, and records each motion as a call that a macro can repeat. */
  @Override
  void finish() {
    tick();
    for (int n = 0; n < ranges.size() && Recorder.record; n++) {
      Pose pose = new Pose().set(poses.get(n));
      if (!pose.sameBits(new Pose())) {
        Recorder.recordString(
            "call(\"" + MOVE + "\", \"" + name(n) + "\", \"" + text(pose) + "\");\n");
      }
    }
    result().show();
    if (session.stop().isInOrder()) {
      autosave.discard();
    }
  }

  /** Returns a new label stack of the fragments where they are. */
  ImagePlus result() {
    List<Pose> restToPresent = poses.stream().map(pose -> new Pose().set(pose)).toList();
    return PlacedLabels.of(stack, ranges, PosedBits.resample(volume, restToPresent, volume.grid()));
  }

  private String name(int n) {
    return ranges.get(n).name();
  }

  private List<String> names() {
    return ranges.stream().map(SegmentRange::name).toList();
  }

  /** Returns the pose of a fragment as macros write it: x,y,z,qw,qx,qy,qz; mm from its place. */
  public String pose(String fragment) throws TouchRefusedException {
    for (int n = 0; n < ranges.size(); n++) {
      if (name(n).equals(fragment)) {
        return text(new Pose().set(poses.get(n)));
      }
    }
    throw new TouchRefusedException("There is no fragment " + fragment + ".");
  }

  private static String text(Pose p) {
    return DoubleStream.of(
            p.translation.x,
            p.translation.y,
            p.translation.z,
            p.rotation.w,
            p.rotation.x,
            p.rotation.y,
            p.rotation.z)
        .mapToObj(NumberText::text)
        .collect(Collectors.joining(","));
  }

  /**
   * Moves a fragment towards a pose, as far as others let it. Any thread.
   *
   * @param text the pose as {@link #pose} returns it
   * @throws TouchRefusedException if there is no such fragment, it is fixed, or the pose is wrong
   */
  public void move(String fragment, String text) throws TouchRefusedException {
    Pose pose = parse(text);
    if (!session.moveBody(fragment, pose)) {
      throw new TouchRefusedException("No fragment " + fragment + " can move.");
    }
  }

  private static Pose parse(String text) throws TouchRefusedException {
    double[] n = Arrays.stream(text.split(",", -1)).mapToDouble(NumberParser::number).toArray();
    Pose pose = new Pose();
    if (n.length == 7) {
      pose.translation.set(n[0], n[1], n[2]);
      pose.rotation.set(n[3], n[4], n[5], n[6]);
    }
    if (n.length != 7 || !pose.isFinite() || !pose.rotation.isNearUnit()) {
      throw new TouchRefusedException(
          "The pose \"" + text + "\" is not x,y,z,qw,qx,qy,qz in mm with a unit quaternion.");
    }
    if (!pose.rotation.isUnit()) {
      pose.rotation.normalize();
    }
    return pose;
  }

  @Override
  public void close() {
    ImagePlus.removeImageListener(this);
    autosave.close();
    super.close();
    realtime.close();
  }

  /** Prints to ImageJ's log, and adds the keys that lock, attach and turn fragments. */
  private final class Listener implements SessionView.Listener {
    @Override
    public void opening(SceneWindow window) {
      new PlacingKeys(session, names(), line -> view.ifPresent(v -> v.hint(line)))
          .addTo(window.input());
    }

    @Override
    public void print(String line) {
      IJ.log("Palpate: " + line);
    }

    @Override
    public void stop() {
      requestStop();
    }
  }
}
