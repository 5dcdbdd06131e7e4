package org.palpate.host;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.collision.CollisionDevice;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.TurnableDevice;
import org.palpate.edit.EditQueue;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.HapticEffect;
import org.palpate.force.MassiveTool;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.force.needle.NeedleTrack;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.scene.ToolMarks;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.PosedBits;

/**
 * A rigid tool among the segments of a contact scene, each of which is a body. Builds its frames.
 *
 * <p>The solver is built once, because grown solids take time and memory. One frame uses it at a
 * time: a warm-up first, then the session. Any thread may build; what is built belongs to the
 * thread that runs it. World millimetres.
 */
public final class ToolScene {
  /** The most points of the tool that an effect sees, so that its work in a frame stays small. */
  private static final int MOST_POINTS_OF_EFFECTS = 200;

  private final ContactScene scene;
  private final BodyScene bodies;
  private final RigidTool tool;
  private final MovableShapes movableShapes;
  private final OptionalDouble rotationalStiffness;
  private final RigidSolver solver;
  private final EditQueue edits;

  /** Written by the thread that makes a frame. */
  private volatile Optional<NeedleTrack> needle = Optional.empty();

  /** Written by the thread that makes a frame. */
  private volatile Optional<MassiveTool> mass = Optional.empty();

  /**
   * Creates a scene in which no body moves.
   *
   * @param scene the volume, its contact settings and its grey values
   * @param bodies the bodies that {@link ContactScene#newBodies} returned
   * @param tool the sample points of the tool
   * @param clearances the clearance from each body
   * @param rotationalStiffness torque per angle, N mm/rad; if empty, it follows from the radius of
   *     the tool
   */
  public ToolScene(
      ContactScene scene,
      BodyScene bodies,
      RigidTool tool,
      List<Clearance> clearances,
      OptionalDouble rotationalStiffness) {
    this(
        scene,
        bodies,
        tool,
        MovableShapes.none(bodies),
        clearances,
        rotationalStiffness,
        CollisionDevice.CPU);
  }

  /**
   * {@return a point among bodies of which some can move} Their sample points keep out of each
   * other's voxels.
   *
   * @param scene the volume with the placements of its bodies, and its contact settings
   * @throws RigidScene.BodiesOverlapException if two bodies of which one can move overlap
   */
  public static ToolScene ofPoint(ContactScene scene) {
    BodyScene bodies = scene.newBodies();
    return new ToolScene(
        scene,
        bodies,
        ToolSampler.point(),
        MovableShapes.ofPoints(bodies),
        List.of(Clearance.POINTS),
        OptionalDouble.empty(),
        CollisionDevice.CPU);
  }

  /**
   * Creates a scene.
   *
   * @param scene the volume, its contact settings and its grey values
   * @param bodies the bodies that {@link ContactScene#newBodies} returned
   * @param tool the sample points of the tool
   * @param shapes the sample points of the bodies that move
   * @param clearances the clearance from each body
   * @param rotationalStiffness torque per angle, N mm/rad; if empty, the stiffness times the
   *     squared rms radius of the tool
   * @param device judges the legs of the tool and of bodies; the caller closes it after the last
   *     frame
   * @throws RigidScene.BodiesOverlapException if two bodies of which one can move overlap
   */
  public ToolScene(
      ContactScene scene,
      BodyScene bodies,
      RigidTool tool,
      MovableShapes shapes,
      List<Clearance> clearances,
      OptionalDouble rotationalStiffness,
      CollisionDevice device) {
    this.scene = scene;
    this.bodies = bodies;
    this.tool = tool;
    movableShapes = shapes;
    this.rotationalStiffness = rotationalStiffness;
    List<GreyIsosurfaceSource> greys = scene.greySource().map(List::of).orElse(List.of());
    solver =
        new RigidSolver(
            new RigidScene(
                bodies,
                tool,
                shapes,
                new RigidSettings(scene.maxStepMm(), clearances, greys, true, device)));
    edits = EditQueue.ofBodies(bodies.grids());
  }

  /** {@return the volume, its contact settings and its grey values} */
  public ContactScene contactScene() {
    return scene;
  }

  /** {@return the sample points of the bodies that move, and the clearance that they keep} */
  public MovableShapes movableShapes() {
    return movableShapes;
  }

  /** {@return the bodies, in the order of the segments} */
  public BodyScene bodies() {
    return bodies;
  }

  /** {@return the bodies where they stand, as segments of the grid of the volume} */
  public SegmentedVolume present() {
    List<Pose> poses =
        IntStream.range(0, bodies.count()).mapToObj(n -> bodies.body(n).pose()).toList();
    return PosedBits.resample(scene.volume(), poses, scene.grid());
  }

  /** {@return whether a body can move} */
  public boolean hasMovableBodies() {
    return movableBodies().findAny().isPresent();
  }

  /** Returns the indices of the bodies that can move. */
  IntStream movableBodies() {
    return IntStream.range(0, bodies.count())
        .filter(n -> bodies.body(n).mobility() == Mobility.MOVABLE);
  }

  /** Returns the index of the first body of a name that can move; empty without one. */
  OptionalInt movableBody(String name) {
    return movableBodies().filter(n -> bodies.body(n).name().equals(name)).findFirst();
  }

  /** {@return the tool} */
  public RigidTool tool() {
    return tool;
  }

  /** {@return sample points of the tool that show its form, tool frame, mm} */
  public List<Vec3> drawnPoints() {
    return points(ToolMarks.MOST_POINTS);
  }

  private List<Vec3> points(int most) {
    int every = (tool.count() + most - 1) / most;
    return IntStream.iterate(0, point -> point < tool.count(), point -> point + every)
        .mapToObj(point -> tool.point(point, new Vec3()))
        .toList();
  }

  /** Returns the solver, which one frame uses at a time. */
  RigidSolver solver() {
    return solver;
  }

  /** {@return the queue that takes changes of the bodies while a session runs} Any thread. */
  public EditQueue edits() {
    return edits;
  }

  /**
   * {@return the coupling of the tool}
   *
   * @param defaultNewtonPerMm stiffness if the settings give none, N per mm of scan
   */
  public RigidCoupling coupling(double defaultNewtonPerMm) {
    double newtonPerMm = scene.settings().stiffnessNewtonPerMm().orElse(defaultNewtonPerMm);
    return rotationalStiffness.isPresent()
        ? new RigidCoupling(newtonPerMm, rotationalStiffness.getAsDouble())
        : RigidCoupling.of(tool, newtonPerMm);
  }

  /**
   * Returns stiffness, friction and damping of each body. Friction has cones; see {@link
   * FrictionForm#CONE}.
   *
   * @param defaultNewtonPerMm stiffness if the settings give none, N per mm of scan
   */
  ForceSettings force(double defaultNewtonPerMm) {
    return scene.force(defaultNewtonPerMm, FrictionForm.CONE);
  }

  /**
   * {@return the settings for the frames of a live session; see {@link ContactScene#liveFrame}}
   *
   * @param device the device, which limits the force unless the settings do
   * @param defaultNewtonPerMm stiffness if the settings give none, N per mm of scan
   */
  public FrameSettings liveFrame(DeviceSpecification device, double defaultNewtonPerMm) {
    return scene.liveFrame(device, force(defaultNewtonPerMm));
  }

  /** Returns the pose of each body at the start, a new list; empty if all stand at rest. */
  List<RigidTransform> startPoses() {
    return Placement.transforms(scene.placements());
  }

  /**
   * {@return the region and the points that a simulated hand presses with the tool, world mm} The
   * points lie above the surface, so that the tool meets the surface about where the hand presses.
   * Their height is the distance from the tool's reference point to its nearest sample point.
   */
  public HandTarget handTarget() {
    HandTarget target = scene.handTarget();
    double standOffMm = nearestPointMm();
    Vec3 middle = target.lowMm().add(target.highMm(), new Vec3()).mul(0.5, new Vec3());
    List<Vec3> raised =
        target.surfaceMm().stream().map(point -> raised(point, middle, standOffMm)).toList();
    return new HandTarget(target.lowMm(), target.highMm(), target.voxelMm(), raised);
  }

  private double nearestPointMm() {
    double least = Double.POSITIVE_INFINITY;
    Vec3 point = new Vec3();
    for (int n = 0; n < tool.count(); n++) {
      least = Math.min(least, tool.point(n, point).length());
    }
    return least;
  }

  private static Vec3 raised(Vec3 point, Vec3 middle, double byMm) {
    Vec3 outward = point.sub(middle, new Vec3());
    double length = outward.length();
    return length > 0 ? outward.mul(1 + byMm / length, outward).add(middle, outward) : point;
  }

  /**
   * {@return a new frame that applies queued edits}
   *
   * @param worldDevice delivers world mm and takes forces and torques along the world's axes
   * @param frame the settings of the frame
   * @param coupling the springs between device and tool
   * @param publisher receives the result of each frame on the haptic thread
   */
  public ToolFrame newFrame(
      HapticDevice worldDevice,
      FrameSettings frame,
      RigidCoupling coupling,
      ToolFramePublisher publisher) {
    ToolFrame made = new ToolFrame(worldDevice, bodies, solver, coupling, frame, edits, publisher);
    scene.carve().ifPresent(made::carve);
    made.watch(scene.approaches());
    made.requestEffects(newEffects(frame, coupling));
    scene.settings().feel().materials().ifPresent(made::use);
    needle = newNeedle(coupling);
    needle.ifPresent(made::use);
    mass = newMass(frame, coupling);
    mass.ifPresent(made::use);
    return made;
  }

  private Optional<MassiveTool> newMass(FrameSettings frame, RigidCoupling coupling) {
    double friction = frame.force().general().slidingFriction();
    return scene
        .settings()
        .feel()
        .mass()
        .map(held -> new MassiveTool(tool, coupling, friction, held));
  }

  /** {@return the mass of the tool in the last frame that was made; empty without one} */
  public Optional<MassiveTool> mass() {
    return mass;
  }

  /** Returns the track of a needle outside of all tissue; empty if nothing is penetrable. */
  private Optional<NeedleTrack> newNeedle(RigidCoupling coupling) {
    List<NeedleTissue> tissues = List.copyOf(scene.tissues().values());
    if (tissues.isEmpty()) {
      return Optional.empty();
    }
    double low = IntStream.range(0, tool.count()).mapToDouble(tool::z).min().orElse(0);
    double high = IntStream.range(0, tool.count()).mapToDouble(tool::z).max().orElse(0);
    return Optional.of(
        new NeedleTrack(
            tissues,
            scene.grid(),
            new Vec3(0, 0, low),
            high - low,
            coupling.stiffnessNewtonPerMm()));
  }

  /** {@return the needle of the last frame that was made; empty without one} */
  public Optional<NeedleTrack> needle() {
    return needle;
  }

  private List<HapticEffect> newEffects(FrameSettings frame, RigidCoupling coupling) {
    return scene.newEffects(
        new EffectSite(
            RigidTransform.identity(),
            coupling.stiffnessNewtonPerMm(),
            coupling.rotationalStiffness(),
            frame.maxForceNewton(),
            points(MOST_POINTS_OF_EFFECTS)));
  }

  /** Returns a frame for the warm-up, which applies no edits and publishes nothing. */
  ToolFrame newWarmUpFrame(HapticDevice worldDevice, FrameSettings frame, RigidCoupling coupling) {
    EditQueue none = EditQueue.ofBodies(bodies.grids());
    ToolFrame made =
        new ToolFrame(worldDevice, bodies, solver, coupling, frame, none, ToolFramePublisher.NONE);
    made.requestEffects(newEffects(frame, coupling));
    scene.settings().feel().materials().ifPresent(made::use);
    newNeedle(coupling).ifPresent(made::use);
    newMass(frame, coupling).ifPresent(made::use);
    return made;
  }

  /**
   * The tool in a session.
   *
   * @param device delivers the poses that the frame follows
   */
  record Held(ToolScene scene, ToolFrame frame, ToolPublisher publisher, HapticDevice device) {

    /** Takes hold of the movable body that is pressed, or lets go of the one that is held. */
    void toggleHold() {
      if (frame.heldBody() < 0) {
        frame.requestTake();
      } else {
        frame.requestLetGo();
      }
    }

    /** Whether {@link #turn} turns bodies, because the device does not. */
    boolean canTurn() {
      return scene.hasMovableBodies() && device instanceof TurnableDevice;
    }

    /** Turns the body in hand by a rotation vector in world axes, rad. Returns whether it may. */
    boolean turn(Vec3 rotationVector) {
      if (frame.heldBody() >= 0
          && device instanceof TurnableDevice turnable
          && turnable.isTurnable()) {
        turnable.turn(rotationVector);
        return true;
      }
      return false;
    }

    /** Returns the pose of each body in the last frame that was taken, from rest to present. */
    List<RigidTransform> bodyPoses() {
      List<RigidTransform> poses = scene.startPoses();
      for (int n = 0; n < poses.size(); n++) {
        poses.set(n, publisher.bodyPose(n).orElse(poses.get(n)));
      }
      return poses;
    }
  }
}
