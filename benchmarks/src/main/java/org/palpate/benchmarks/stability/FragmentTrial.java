package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.body.Body;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.force.HapticEffect;
import org.palpate.force.guide.FitExchange;
import org.palpate.force.guide.FitTarget;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop with a fragment in hand, whose fracture faces meet those of a
 * fragment that stands still. The hand means to put it beside its place and turned. The guide
 * {@code fit} may pull it there.
 *
 * <p>The fit comes as late as one that another thread computes, see {@link FittingDevice}.
 *
 * @param device the device; its largest torque is taken to be its force at the grip radius
 * @param grip the person
 * @param sampling rate and delay
 * @param guided whether the fit guides the hand
 */
record FragmentTrial(DeviceModel device, Grip grip, Sampling sampling, boolean guided)
    implements HeldTrial {
  private static final double VOXEL_MM = TouchedShape.VOXEL_MM;
  private static final int EDGE = 28;
  private static final int BORDER = 4;

  /** The amplitude of the fracture's hills and furrows, voxels. */
  private static final double HILLS = 2.5;

  private static final int FIXED = 0;
  private static final int HELD = 1;

  /** The distance of the place that the hand means from the right one, along x. */
  private static final double ASIDE_MM = 0.7;

  /** The rotation of the fragment that the hand means. */
  private static final Quaternion TURNED =
      new Quaternion().setRotationVector(new Vec3(0.02, -0.01, 0.03));

  private static final Vec3 INWARD = new Vec3(0, 0, -1);

  /** The force with which the hand means to press; a harder one tilts a small fragment away. */
  private static final double PRESSED_NEWTON = 1;

  private static final double MAX_STEP_MM = 8 * VOXEL_MM;

  private static final VoxelGrid GRID =
      new VoxelGrid(
          EDGE, EDGE, EDGE, new Vec3(VOXEL_MM, VOXEL_MM, VOXEL_MM), RigidTransform.identity());

  private static final List<BitCube> FRAGMENTS = List.of(fragment(FIXED), fragment(HELD));

  /** The sample points of the fragment in hand. */
  private static final RigidTool SHAPE = ToolSampler.ofSegment(FRAGMENTS.get(HELD), GRID);

  /** The fit of the fragments. One thread runs all trials. */
  private static final FaceFit FIT = new FaceFit(GRID, FRAGMENTS, OptionalDouble.of(0));

  @Override
  public String heldName() {
    return guided ? "fragment, guide fit" : "fragment";
  }

  @Override
  public double lengthMm() {
    return 0;
  }

  @Override
  public double rmsRadiusMm() {
    return SHAPE.rmsRadiusMm();
  }

  @Override
  public Outcome run(double newtonPerM) {
    return run(newtonPerM, ToolFramePublisher.NONE);
  }

  @Override
  public double givenMillijoule(double newtonPerM) {
    HandWork work = new HandWork(1);
    run(newtonPerM, work);
    return work.millijoule();
  }

  private Outcome run(double newtonPerM, ToolFramePublisher publisher) {
    Vec3 place = SHAPE.referenceMm(new Vec3());
    Vec3 touchMm = new Vec3(place.x + ASIDE_MM, place.y, place.z);
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, touchMm, INWARD, PRESSED_NEWTON);
    Plant plant = loop.turningPlant(TURNED);
    FrameSettings settings = ClosedLoop.settings(plant.specification(), newtonPerM, true);
    BodyScene bodies = bodies(loop.startMm());
    FitExchange fits = new FitExchange();
    HapticDevice hand = new SettlingDevice(plant, sampling);
    RigidTool point = ToolSampler.point();
    RigidCoupling coupling = RigidCoupling.of(point, settings.force().stiffnessNewtonPerMm());
    ToolFrame frame =
        new ToolFrame(
            guided ? new FittingDevice(hand, sampling, fits, () -> fit(bodies)) : hand,
            bodies,
            solver(bodies, point),
            coupling,
            settings,
            EditQueue.ofBodies(bodies.grids()),
            publisher);
    if (guided) {
      frame.requestEffects(List.of(guide(fits, coupling, settings)));
    }
    frame.run(-sampling.periodNanos());
    frame.repeat(HELD, BodyEvent.TAKEN, new Pose(), new Pose());
    return loop.run(plant, frame);
  }

  /** Returns the fragments, of which the one in hand is where the hand begins. */
  private static BodyScene bodies(Vec3 startMm) {
    Body held = new Body("held", FRAGMENTS.get(HELD), GRID, Mobility.MOVABLE);
    Pose pose = new Pose();
    pose.rotation.set(TURNED);
    startMm.sub(TURNED.rotate(SHAPE.referenceMm(new Vec3()), new Vec3()), pose.translation);
    held.setPose(pose);
    return new BodyScene(
        List.of(new Body("fixed", FRAGMENTS.get(FIXED), GRID, Mobility.FIXED), held));
  }

  private static RigidSolver solver(BodyScene bodies, RigidTool point) {
    RigidSettings settings = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    return new RigidSolver(new RigidScene(bodies, point, MovableShapes.ofPoints(bodies), settings));
  }

  private static HapticEffect guide(
      FitExchange fits, RigidCoupling coupling, FrameSettings settings) {
    return Guides.fit(fits, GuideStrength.STANDARD).make(HeldTrial.site(coupling, settings));
  }

  private static Optional<FitTarget> fit(BodyScene bodies) {
    List<Pose> poses = List.of(bodies.body(FIXED).pose(), bodies.body(HELD).pose());
    return FIT.fit(HELD, other -> false, poses);
  }

  /** Returns a block of voxels below the fracture, or the one above it. */
  private static BitCube fragment(int which) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      boolean isAbove = k >= EDGE / 2 + HILLS * (Math.sin(i / 3.5) + Math.sin(j / 4.5));
      if (isInBlock(i) && isInBlock(j) && isInBlock(k) && isAbove == (which == HELD)) {
        bits.set(i, j, k);
      }
    }
    return bits;
  }

  private static boolean isInBlock(int voxel) {
    return voxel >= BORDER && voxel < EDGE - BORDER;
  }

  /**
   * A device that lets a fragment be fitted on the clock of its samples, at the rate of a session.
   * A fit begins with the poses of one frame, and is used as soon as the next fit begins. So it is
   * as late as one that another thread computes.
   */
  private static final class FittingDevice extends DeviceDecorator {
    /** The time between two fits of a session: it fits some ten times a second. */
    private static final double FIT_SECONDS = 0.1;

    private final FitExchange fits;
    private final Supplier<Optional<FitTarget>> fit;
    private final long framesPerFit;
    private Optional<FitTarget> next = Optional.empty();
    private long reads;

    /**
     * Creates a device.
     *
     * @param fits receives the fits
     * @param fit fits the fragment where it is now
     */
    FittingDevice(
        HapticDevice device,
        Sampling sampling,
        FitExchange fits,
        Supplier<Optional<FitTarget>> fit) {
      super(device);
      this.fits = fits;
      this.fit = fit;
      framesPerFit = Math.round(FIT_SECONDS * sampling.rateHz());
    }

    @Override
    public ReadStatus read(DeviceState state) {
      if (reads++ % framesPerFit == 0) {
        fits.offer(next.orElse(null));
        next = fit.get();
      }
      return device.read(state);
    }
  }
}
