package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.GreyEdit;
import org.palpate.edit.HistoryEdit;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.GreyMaterials;
import org.palpate.force.HapticEffect;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.force.MassiveTool;
import org.palpate.force.Material;
import org.palpate.force.effect.Effects;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.force.needle.NeedleTrack;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.HapticLoop;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.loop.ManualClock;
import org.palpate.loop.ThreadSetup;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.recording.FrameRecorder;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.testing.Floor;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;

/** Measures a whole frame: device, edits, solver, force, recorder, sync, loop and histograms. */
class FrameAllocationTest {
  private static final int FRAMES = 100_000;

  /** The JVM itself allocates a little when it links or recompiles the code of frames. */
  private static final int MAX_ROUNDS = 8;

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private final Floor floor = Floor.make();
  private final ManualClock clock = new ManualClock();
  private final SampleRecorder recorder = new SampleRecorder();
  private final FrameRecorder frames = new FrameRecorder();
  private final List<Long> allocated = new ArrayList<>(MAX_ROUNDS);
  private final Edit[] waiting = new Edit[MAX_ROUNDS * FRAMES / 100];

  /** Whether the frames have already done all that has to allocate nothing. */
  private BooleanSupplier isComplete = () -> true;

  @Test
  void aHundredThousandWarmFramesAllocateNothing() {
    prepareEdits(1.5);
    Accumulator accumulator = new Accumulator();
    TouchProperties touch = new TouchProperties(accumulator);
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = new SimulatedDevice(7, target, ManualClock.MS);
    MeasuringDevice measured = new MeasuringDevice(new RecordingDevice(hand, recorder));
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(measured),
            new GuardedSolver(Floor.METRIC, 8),
            floor.scene,
            Floor.METRIC,
            FrameSettings.live(hand.specification(), Floor.settings().force()),
            floor.edits,
            touch::publish);
    frame.carve(CarveSettings.ofRate(5));
    assertARoundAllocatesNothing(frame);
    assertTrue(accumulator.take());
  }

  @Test
  void aHundredThousandWarmFramesOfARigidToolAllocateNothing() {
    prepareEdits(2.6);
    ToolFrame frame = toolFrame(roughFloor());
    frame.carve(CarveSettings.ofRate(5));
    assertARoundAllocatesNothing(frame);
    assertTrue(frame.statistics().maxTorqueNewtonMm() > 0);
  }

  /** Returns a frame of a capsule that a hand moves into the floor. */
  private ToolFrame toolFrame(ForceSettings force) {
    BodyScene bodies =
        new BodyScene(List.of(new Body("floor", floor.bits, Floor.GRID, Mobility.FIXED)));
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.7);
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = SimulatedDevice.withOrientation(7, target, ManualClock.MS);
    return new ToolFrame(
        new MeasuringDevice(new RecordingDevice(hand, recorder)),
        bodies,
        new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(8, bodies, tool)),
        RigidCoupling.of(tool, 0.5),
        FrameSettings.live(hand.specification(), force),
        floor.edits,
        ToolFramePublisher.NONE);
  }

  /** Also measures some updates of elastic segments, which come between two frames. */
  @Test
  void aHundredThousandWarmFramesOfAnElasticFloorAllocateNothing() {
    prepareEdits(1.5);
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = new SimulatedDevice(7, target, ManualClock.MS);
    ElasticMaterial soft = new ElasticMaterial(20e3, 0.4);
    ControlLattice lattice =
        new ControlLattice(
            Floor.METRIC, List.of(new ElasticSegment(floor.bits, soft)), List.of(), 16);
    ElasticBody body = new ElasticBody(lattice, Floor.METRIC);
    SynchronousUpdates updates = new SynchronousUpdates(body);
    HapticDevice updating =
        new DeviceDecorator(hand) {
          private int reads;

          @Override
          public ReadStatus read(DeviceState state) {
            if (reads++ % 20 == 0) {
              updates.beforeFrame();
            }
            return device.read(state);
          }
        };
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(new MeasuringDevice(updating)),
            new SmoothSolver(Floor.METRIC, 8),
            floor.scene,
            Floor.METRIC,
            FrameSettings.live(hand.specification(), Floor.settings().force()),
            floor.edits,
            FramePublisher.NONE);
    frame.deform(body.contact());
    assertARoundAllocatesNothing(frame);
    assertTrue(body.counters().updates() > 100);
  }

  @Test
  void aHundredThousandWarmFramesWithGuidesEffectsMassAndGreyValuesAllocateNothing() {
    prepareEdits(1.5);
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = new SimulatedDevice(7, target, ManualClock.MS);
    FrameSettings settings = FrameSettings.live(hand.specification(), Floor.settings().force());
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(new MeasuringDevice(new RecordingDevice(hand, recorder))),
            new SmoothSolver(Floor.METRIC, 8),
            floor.scene,
            Floor.METRIC,
            settings,
            floor.edits,
            FramePublisher.NONE);
    frame.requestEffects(everyEffect(0));
    MassSettings held = new MassSettings(0.02, new Vec3(0, 0, -9810));
    frame.give(new MassiveContact(Floor.METRIC, settings.force(), held));
    frame.use(new GreyMaterials(greyValues(), GreyMaterials.CT));
    assertARoundAllocatesNothing(frame);
  }

  /** Every fourth edit replaces the grey values of the floor, whose top stays the isosurface. */
  @Test
  void aHundredThousandWarmFramesOverGreyValuesThatAreReplacedAllocateNothing() {
    prepareEdits(1.5);
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < Floor.EDGE * Floor.EDGE * Floor.EDGE; n++) {
      int k = n / (Floor.EDGE * Floor.EDGE);
      values.set(n % Floor.EDGE, n / Floor.EDGE % Floor.EDGE, k, 40 * (Floor.TOP - k) - 20);
    }
    GreyIsosurface steep = new GreyIsosurface(values, 0, 20);
    GreyIsosurface gentle = new GreyIsosurface(values, 0, 60);
    GreyIsosurfaceSource grey = new GreyIsosurfaceSource(steep);
    for (int n = 0; n < waiting.length; n += 4) {
      waiting[n] = new GreyEdit(0, grey, n % 8 == 0 ? gentle : steep);
    }
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = new SimulatedDevice(7, target, ManualClock.MS);
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(new MeasuringDevice(new RecordingDevice(hand, recorder))),
            new SmoothSolver(Floor.METRIC, 8, grey),
            floor.scene,
            Floor.METRIC,
            FrameSettings.live(hand.specification(), Floor.settings().force()),
            floor.edits,
            FramePublisher.NONE);
    assertARoundAllocatesNothing(frame);
  }

  @Test
  void aHundredThousandWarmFramesOfARigidToolWithGuidesAndEffectsAllocateNothing() {
    prepareEdits(2.6);
    ToolFrame frame = toolFrame(Floor.settings().force());
    frame.requestEffects(everyEffect(2));
    frame.use(new GreyMaterials(greyValues(), GreyMaterials.CT));
    assertARoundAllocatesNothing(frame);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aHundredThousandWarmFramesOfANeedleAndOfAToolWithMassAllocateNothing(boolean isNeedle) {
    prepareEdits(2.6);
    BodyScene bodies =
        new BodyScene(List.of(new Body("floor", floor.bits, Floor.GRID, Mobility.FIXED)));
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.7);
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = SimulatedDevice.withOrientation(7, target, ManualClock.MS);
    RigidCoupling coupling = RigidCoupling.of(tool, 0.5);
    ToolFrame frame =
        new ToolFrame(
            new MeasuringDevice(new RecordingDevice(hand, recorder)),
            bodies,
            new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(8, bodies, tool)),
            coupling,
            FrameSettings.live(hand.specification(), roughFloor()),
            floor.edits,
            ToolFramePublisher.NONE);
    frame.use(
        isNeedle
            ? new NeedleTrack(
                List.of(new NeedleTissue(layer(), 0.2, 0.1, 0.02)),
                Floor.GRID,
                new Vec3(0, 0, -3),
                6,
                0.5)
            : new MassiveTool(tool, coupling, 0.2, new MassSettings(0.05, new Vec3(0, 0, -9810))));
    assertARoundAllocatesNothing(frame, !isNeedle);
  }

  /** Returns voxels above the floor. */
  private static BitCube layer() {
    BitCube bits = new BitCube(Floor.EDGE, Floor.EDGE, Floor.EDGE);
    for (int n = 0; n < Floor.EDGE * Floor.EDGE; n++) {
      for (int k = Floor.TOP; k < Floor.TOP + 3; k++) {
        bits.set(n % Floor.EDGE, n / Floor.EDGE, k);
      }
    }
    return bits;
  }

  private static ScalarVolume greyValues() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(n % 32, n / 32 % 32, n / 1024, 40 * (n % 32) - 100 + n % 7);
    }
    return values;
  }

  private List<HapticEffect> everyEffect(double rotationalStiffness) {
    EffectSite site =
        new EffectSite(
            RigidTransform.identity(),
            0.5,
            rotationalStiffness,
            Double.POSITIVE_INFINITY,
            List.of(new Vec3(), new Vec3(0, 0, 1)));
    Vec3 middle = new Vec3(16, 16, 10);
    GuideStrength weak = new GuideStrength(OptionalDouble.of(0.01), OptionalDouble.of(0.1), 40);
    SegmentDistance distance = new SegmentDistance(floor.bits, Floor.GRID, 3);
    List<HapticEffect> effects = new ArrayList<>();
    for (EffectPlan plan :
        List.of(
            Guides.axis(middle, new Vec3(0, 0, 1), weak),
            Guides.plane(middle, new Vec3(1, 0, 0), weak),
            Guides.ball(middle, 3, weak),
            Guides.hinge(middle, new Vec3(0, 1, 0), weak),
            Guides.path(List.of(new Vec3(), middle, new Vec3(30, 0, 9)), weak),
            Guides.align(new Vec3(0, 0, 1), weak),
            Guides.away(distance, 3, weak),
            Effects.viscosity(0.0001),
            Effects.magnet(distance, 0.1, 3),
            Effects.stickSlip(0.1),
            Effects.vibration(50, 0.1),
            Effects.texture(greyValues(), 0.001))) {
      effects.add(plan.make(site));
    }
    return effects;
  }

  /** Returns settings with materials, friction and damping, so that a frame computes them all. */
  private static ForceSettings roughFloor() {
    Material floor = new Material(0.6, 0.4, 0.3, 0.001);
    return new ForceSettings(
        Material.of(0.5, 0.2, FrictionForm.CONE), FrictionForm.CONE, true, List.of(floor));
  }

  private void prepareEdits(double radiusMm) {
    for (int i = 0; i < waiting.length; i++) {
      Vec3 centre = new Vec3(3 + i % 26, 3 + i / 26 % 26, 8);
      waiting[i] = i % 3 == 2 ? HistoryEdit.undo() : new BrushEdit(0, centre, radiusMm, i % 2 == 0);
    }
  }

  /**
   * Runs rounds of frames in contact, with solids that come to the tool, until one allocates
   * nothing.
   */
  private void assertARoundAllocatesNothing(HapticFrame frame) {
    assertARoundAllocatesNothing(frame, true);
  }

  private void assertARoundAllocatesNothing(HapticFrame frame, boolean isFreed) {
    isComplete = () -> !isFreed || frame.statistics().freed() > 0;
    LoopSettings settings =
        new LoopSettings(
            ManualClock.MS, clock, clock, ThreadSetup.NONE, () -> {}, 1000 * ManualClock.MS);
    frame.observe(frames);
    HapticLoop loop = new HapticLoop(frame, settings, end -> {});
    loop.run();
    assertEquals(LoopEnd.Cause.DEVICE_GONE, loop.end().cause());
    FrameStatistics counts = frame.statistics();
    assertTrue(counts.contactFrames() > counts.frames() / 10, counts.toString());
    assertTrue(!isFreed || counts.freed() > 0, "solids came to the tool");
    long last = allocated.get(allocated.size() - 1);
    assertEquals(0, last, "bytes by rounds of " + FRAMES + " frames: " + allocated);
  }

  /**
   * Measures the thread's allocations after every round and queues an edit every hundred frames. It
   * disconnects after a round without an allocation, once the frames have done all that they must.
   */
  private final class MeasuringDevice implements HapticDevice {
    private final HapticDevice device;
    private int reads;
    private long before;

    MeasuringDevice(HapticDevice device) {
      this.device = device;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      if (reads % FRAMES == 0 && endsRound()) {
        return ReadStatus.DISCONNECTED;
      }
      if (reads % 100 == 0) {
        floor.edits.offer(waiting[reads / 100]);
      }
      if (reads++ % 1000 == 0) {
        recorder.drainTo((sample, flags) -> {});
        frames.drainTo(record -> {});
      }
      return device.read(state);
    }

    private boolean endsRound() {
      long bytes = threads.getCurrentThreadAllocatedBytes() - before;
      if (reads > 0) {
        allocated.add(bytes);
      }
      boolean isWarm = bytes == 0 && isComplete.getAsBoolean();
      before = threads.getCurrentThreadAllocatedBytes();
      return reads > 0 && (isWarm || allocated.size() == MAX_ROUNDS);
    }

    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      return device.write(forceNewton, torqueNewtonMm);
    }

    @Override
    public org.palpate.device.DeviceSpecification specification() {
      return device.specification();
    }

    @Override
    public void close() {
      device.close();
    }
  }
}
