package org.palpate.host;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.TurnedDevice;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticThread;
import org.palpate.elastic.PublishedShape;
import org.palpate.force.MassiveContact;
import org.palpate.frame.FrameObserver;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.HapticFrame;
import org.palpate.frame.PointFrame;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.HapticLoop;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopReport;
import org.palpate.loop.LoopStatus;
import org.palpate.loop.NanoClock;
import org.palpate.loop.WarmUp;
import org.palpate.recording.EditRecorder;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.rigid.RigidCoupling;
import org.palpate.scene.SynchronizationThread;
import org.palpate.sync.Accumulator;
import org.palpate.sync.SyncCounters;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.VoxelGrid;

/**
 * A live session: a haptic thread of its own moves a device through a scene.
 *
 * <pre>
 *   try (TouchSession session =
 *       new TouchSession(scene, device, SessionSettings.standard())) {
 *     session.start();
 *     while (!session.supervise()) {
 *       LockSupport.parkNanos(TouchSession.SUPERVISION_PERIOD_NANOS);
 *     }
 *   }
 * </pre>
 *
 * <p>Closing the session sends zero force last and closes the device; close it whatever happens.
 * One thread creates, supervises and closes a session; any thread may call {@link #stop}.
 */
public final class TouchSession implements AutoCloseable {
  private static final long WARM_UP_SEED = 1;

  /** The time for which a session waits for updates of elastic segments to come back. */
  public static final long TROUBLE_NANOS = 5_000_000_000L;

  /** Time between two calls of {@link #supervise}, 30 a second. */
  public static final long SUPERVISION_PERIOD_NANOS = SynchronizationThread.PERIOD_NANOS;

  private final HapticDevice device;
  private HapticFrame frame;
  private final HapticLoop loop;
  private final ContactTuning tuning;
  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final Optional<ToolScene.Held> held;
  private final Optional<MassiveContact> mass;
  private final Optional<ElasticBody> elastic;
  private final Optional<ElasticThread> elasticThread;
  private final VoxelGrid grid;

  /** The time since which no update of elastic segments comes; later the supervising thread's. */
  private long troubledSinceNanos;

  /** The reason for which no update comes; null as long as they come. */
  private volatile String elasticTrouble;

  /** Whether the session ended for that reason. */
  private volatile boolean endedByTrouble;

  /** Set before the haptic thread starts, which reads it; null without a second reader. */
  private SessionReader secondReader;

  /** Set before the haptic thread starts, which writes it; null if nobody draws the shape. */
  private PublishedShape shape;

  /** Set before the haptic thread starts, which writes it; null without a reader of changes. */
  private EditRecorder changes;

  private final EditQueue edits;
  private final boolean cuts;
  private boolean started;
  private long ticks;

  /**
   * Creates a session.
   *
   * @param scene the volume and its contact settings; no other session uses it
   * @param worldDevice the device with positions in world mm; closed with the session
   * @param settings pace, recorders, elastic segments and listener
   */
  public TouchSession(ContactScene scene, HapticDevice worldDevice, SessionSettings settings) {
    device = recorded(worldDevice, settings.recorder());
    DeviceSpecification specification = worldDevice.specification();
    FrameSettings frameSettings =
        scene.liveFrame(specification, settings.defaultNewtonPerMm(scene, specification));
    PointFrame frame =
        scene.newFrame(GridDevice.fromWorld(device, scene.grid()), frameSettings, this::publish);
    grid = scene.grid();
    edits = scene.edits();
    cuts = scene.carve().isPresent();
    HapticDevice hand = new SimulatedDevice(WARM_UP_SEED, scene.handTarget(), WarmUp.PERIOD_NANOS);
    Runnable warmUp =
        WarmUp.ofSession(scene.newWarmUpFrame(hand, frameSettings, settings.elastic()), device);
    elastic = settings.elastic().map(Supplier::get);
    long sampleNanos = Math.max(settings.loop().periodNanos(), specification.reportIntervalNanos());
    elastic.ifPresent(body -> frame.deform(body.contact().paced(sampleNanos)));
    tuning =
        new ContactTuning(frame, scene, frameSettings.force(), specification, elastic.isPresent());
    elastic.ifPresent(
        body ->
            settings
                .fieldRecorder()
                .ifPresent(to -> body.listen(to.listener(frame::sampleOfChanges))));
    elasticThread = elastic.map(ElasticThread::new);
    loop = newLoop(frame, settings, warmUp);
    held = Optional.empty();
    mass = frame.mass();
  }

  /**
   * Creates a session with a rigid tool. Otherwise as the other constructor.
   *
   * @param scene the tool among bodies; no other session uses it meanwhile
   * @param worldDevice the device with poses in the world; closed with the session
   * @param settings pace, recorders and listener
   */
  public TouchSession(ToolScene scene, HapticDevice worldDevice, SessionSettings settings) {
    HapticDevice turnable = TurnedDevice.of(worldDevice, this::isHolding);
    device = recorded(turnable, settings.recorder());
    DeviceSpecification specification = worldDevice.specification();
    double defaultNewtonPerMm = settings.defaultNewtonPerMm(scene.contactScene(), specification);
    FrameSettings frameSettings = scene.liveFrame(specification, defaultNewtonPerMm);
    RigidCoupling coupling = scene.coupling(defaultNewtonPerMm);
    grid = scene.contactScene().grid();
    edits = scene.edits();
    cuts = scene.contactScene().carve().isPresent();
    ToolPublisher publisher = new ToolPublisher(properties, grid, scene.bodies());
    ToolFrame frame = scene.newFrame(device, frameSettings, coupling, published(publisher));
    settings
        .bodyRecorder()
        .ifPresent(recorder -> frame.listen(recorder.listener(frame::sampleOfChanges)));
    tuning = ContactTuning.ofTool(frame, frameSettings.force(), specification);
    HapticDevice hand =
        SimulatedDevice.withOrientation(WARM_UP_SEED, scene.handTarget(), WarmUp.PERIOD_NANOS);
    Runnable warmUp = WarmUp.ofSession(scene.newWarmUpFrame(hand, frameSettings, coupling), device);
    loop = newLoop(frame, settings, warmUp);
    held = Optional.of(new ToolScene.Held(scene, frame, publisher, turnable));
    mass = Optional.empty();
    elastic = Optional.empty();
    elasticThread = Optional.empty();
  }

  private static HapticDevice recorded(HapticDevice device, Optional<SampleRecorder> recorder) {
    return recorder.isPresent() ? new RecordingDevice(device, recorder.get()) : device;
  }

  /** {@return whether the hand holds a body} Any thread. */
  public boolean isHolding() {
    return frame instanceof ToolFrame tool && tool.heldBody() >= 0;
  }

  private HapticLoop newLoop(HapticFrame frame, SessionSettings settings, Runnable warmUp) {
    this.frame = frame;
    EditRecorder recorder = settings.editRecorder().orElse(null);
    frame
        .voxels()
        .listen(
            (segment, i, j, k, solid) -> {
              if (recorder != null) {
                recorder.offer(frame.sampleOfChanges(), segment, i, j, k, solid);
              }
              if (changes != null) {
                changes.offer(frame.sampleOfChanges(), segment, i, j, k, solid);
              }
            });
    return new HapticLoop(frame, settings.loop().withWarmUp(warmUp), settings.listener());
  }

  /** Publishes the frame of a point to both readers. Haptic thread. */
  private void publish(Vec3 deviceGrid, Vec3 point, Vec3 newton, boolean contact, long frame) {
    if (shape != null) {
      shape.setFrame();
    }
    properties.publish(deviceGrid, point, newton, contact, frame);
    if (secondReader != null) {
      secondReader.properties().publish(deviceGrid, point, newton, contact, frame);
    }
  }

  /** Returns a publisher of a tool's frames for both readers. */
  private ToolFramePublisher published(ToolPublisher first) {
    return (devicePose, motion, newton, torque, frame) -> {
      first.publish(devicePose, motion, newton, torque, frame);
      if (secondReader != null) {
        secondReader.toolPublisher().publish(devicePose, motion, newton, torque, frame);
      }
    };
  }

  /**
   * {@return a second reader of the published frames, beside {@link #properties}} Call it once,
   * before {@link #start}.
   *
   * @throws IllegalStateException if it was called before or the session has started
   */
  public SessionReader secondReader() {
    if (started || secondReader != null) {
      throw new IllegalStateException("a second reader is made once, before the session starts");
    }
    secondReader = new SessionReader(grid, held.map(tool -> tool.scene().bodies()));
    return secondReader;
  }

  /**
   * Returns the voxels that frames change, for one reader. Call it once, before {@link #start}.
   *
   * @throws IllegalStateException if it was called before or the session has started
   */
  EditRecorder changes() {
    if (started || changes != null) {
      throw new IllegalStateException(
          "a reader of changes is made once, before the session starts");
    }
    changes = new EditRecorder();
    return changes;
  }

  /** {@return the shape of elastic segments, if any, to read with the properties; before start} */
  public Optional<PublishedShape> shape() {
    shape = elastic.map(body -> body.publish(properties.accumulator())).orElse(null);
    return Optional.ofNullable(shape);
  }

  /**
   * Sets the observer of frames. Call it before {@link #start}.
   *
   * @param observer receives what each frame did, on the haptic thread
   */
  public void observe(FrameObserver observer) {
    frame.observe(observer);
  }

  /** Whether the tool cuts. */
  boolean cuts() {
    return cuts;
  }

  /** {@return whether a body can be taken in hand} */
  public boolean canHold() {
    return held.isPresent() && held.get().scene().hasMovableBodies();
  }

  /**
   * Takes hold of the movable body that the tool presses most, or lets go of the body that is held,
   * in the next frame. Any thread.
   */
  public void toggleHold() {
    held.ifPresent(ToolScene.Held::toggleHold);
  }

  /** {@return whether {@link #turnHeld} turns bodies: the device's own samples do not} */
  public boolean canTurnHeld() {
    return held.filter(ToolScene.Held::canTurn).isPresent();
  }

  /**
   * Turns the body in hand about the device's point, at a bounded rate; see {@link TurnedDevice}.
   * Any thread.
   *
   * @param rotationVector axis times angle, world axes, rad; finite, at most pi in length
   * @return false if no body is held, or the device turns it itself
   */
  public boolean turnHeld(Vec3 rotationVector) {
    return held.isPresent() && held.get().turn(rotationVector);
  }

  /**
   * {@return the pose of each body in the last frame that was taken, from rest to present, world
   * mm; a new list, empty for a point} For the reader of {@link #properties}, after the first
   * frame.
   */
  public List<RigidTransform> bodyPoses() {
    return held.map(ToolScene.Held::bodyPoses).orElseGet(List::of);
  }

  /** {@return the frame of the rigid tool, for its methods that are for any thread} */
  public Optional<ToolFrame> toolFrame() {
    return held.map(ToolScene.Held::frame);
  }

  /**
   * Moves a body towards a pose from the next frame on, as {@link ToolFrame#requestPose} does. Any
   * thread.
   *
   * @param name the name of the segment
   * @param restToPresent world mm
   * @return false if the scene has no body of this name that can move
   * @throws IllegalArgumentException if the pose is not finite or has no unit quaternion
   */
  public boolean moveBody(String name, Pose restToPresent) {
    OptionalInt body = held.map(tool -> tool.scene().movableBody(name)).orElse(OptionalInt.empty());
    body.ifPresent(index -> held.orElseThrow().frame().requestPose(index, restToPresent));
    return body.isPresent();
  }

  /**
   * Undoes the last edit, cut or placement of a body, as soon as no earlier edit waits. Without one
   * nothing happens, nor if a body that {@link #moveBody} moved is where the placed one was. Any
   * thread.
   *
   * @return false if the queue of edits is full; then try again later
   */
  public boolean undo() {
    return offer(HistoryEdit.undo());
  }

  /**
   * Redoes what was undone last, as soon as no earlier edit waits, with the exceptions of {@link
   * #undo}. Any thread.
   *
   * @return false if the queue of edits is full; then try again later
   */
  public boolean redo() {
    return offer(HistoryEdit.redo());
  }

  /**
   * Queues an edit of the segments. Any thread.
   *
   * @param edit a new edit, which nobody changes from now on
   * @return false if the queue of edits is full; then try again later
   */
  public boolean offer(Edit edit) {
    return edits.offer(edit);
  }

  /** Starts the haptic thread. It warms up and then switches the force on. */
  public void start() {
    started = true;
    troubledSinceNanos = NanoClock.SYSTEM.nanoTime();
    elasticThread.ifPresent(ElasticThread::start);
    loop.start();
  }

  /**
   * Ends the session if a frame does not return, or if elastic segments have not been updated for
   * {@link #TROUBLE_NANOS} longer than an update may take. Call it about 30 times a second.
   *
   * @return whether the session has ended
   */
  public boolean supervise() {
    long nowNanos = NanoClock.SYSTEM.nanoTime();
    boolean ended = loop.supervise(nowNanos);
    if (!ended && isTroubled(nowNanos)) {
      endedByTrouble = true;
      loop.stop();
      ended = true;
    }
    return ended;
  }

  private boolean isTroubled(long nowNanos) {
    String trouble = elasticThread.flatMap(ElasticThread::trouble).orElse(null);
    if (trouble == null) {
      troubledSinceNanos = nowNanos;
    } else {
      elasticTrouble = trouble;
    }
    return nowNanos - troubledSinceNanos > TROUBLE_NANOS;
  }

  /**
   * {@return the reason for which updates of elastic segments failed to come at any time; empty if
   * they always came} Meanwhile the last proved shape stays. Any thread.
   */
  public Optional<String> elasticTrouble() {
    return Optional.ofNullable(elasticTrouble);
  }

  /** {@return what an update of elastic segments threw, if one failed} Any thread. */
  public Optional<Throwable> elasticFailure() {
    return elasticThread.flatMap(ElasticThread::failure);
  }

  /**
   * {@return whether the session ended because elastic segments were no longer updated} Any thread.
   */
  public boolean endedByTrouble() {
    return endedByTrouble;
  }

  /** {@return the elastic segments, if there are any; their counters after {@link #stop}} */
  public Optional<ElasticBody> elastic() {
    return elastic;
  }

  /**
   * Takes what the frames have published, so that {@link #properties} shows it.
   *
   * <p>For a session without a {@link SessionView}; a view does this itself.
   */
  public void takeUpdates() {
    ticks++;
    properties.accumulator().take();
    properties.markApplied();
  }

  /** {@return the tuning of stiffness, friction and solver} Any thread. */
  public ContactTuning tuning() {
    return tuning;
  }

  /** Returns the rigid tool that the session holds; empty if it touches with a point. */
  Optional<ToolScene.Held> held() {
    return held;
  }

  /**
   * {@return the most points of the tool that kept less than their clearance in any frame; complete
   * after {@link #stop}, and 0 for a point}
   */
  public int mostReducedPoints() {
    return held.map(tool -> tool.frame().mostReducedPoints()).orElse(0);
  }

  /** {@return the body that an interaction point follows, if it has a mass; after {@link #stop}} */
  public Optional<MassiveContact> mass() {
    return mass;
  }

  /** {@return the present state of the loop} Any thread. */
  public LoopStatus status() {
    return loop.status();
  }

  /**
   * {@return what the frames publish} It has one reader: a view, or the caller of {@link
   * #takeUpdates}.
   */
  public TouchProperties properties() {
    return properties;
  }

  /** {@return how often {@link #takeUpdates} was called} */
  public long ticks() {
    return ticks;
  }

  /** {@return how often properties were published and applied; complete after {@link #stop}} */
  public SyncCounters syncCounters() {
    return properties.accumulator().counters();
  }

  /**
   * Ends the session and waits until zero force was sent. Any thread, any number of times.
   *
   * @return how the loop ended, now or earlier
   */
  public LoopEnd stop() {
    LoopEnd end = loop.stop();
    elasticThread.ifPresent(ElasticThread::close);
    return end;
  }

  /** {@return the measurements; complete after {@link #stop}} */
  public LoopReport report() {
    return loop.report();
  }

  /** Ends the session and closes the device. */
  @Override
  public void close() {
    try {
      stop();
    } finally {
      device.close();
    }
  }
}
