package org.palpate.host;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.edit.GreyEdit;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.HapticEffect;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.force.Material;
import org.palpate.force.guide.NearestApproach;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * Builds collision scenes, solvers and haptic frames from a segmented volume and its contact
 * settings.
 *
 * <p>One contact scene holds the queue of edits of one session. Any thread may build; what is built
 * belongs to the thread that runs it. Positions are grid coordinates unless a name says otherwise.
 */
public final class ContactScene {
  private static final Placement AT_REST = new Placement(Mobility.FIXED, new Pose());

  private final SegmentedVolume volume;
  private final List<Placement> placements;
  private final ContactSettings settings;
  private final GridMetric metric;
  private final double maxStepMm;
  private final EditQueue edits;
  private final Optional<GreyIsosurfaceSource> grey;

  /** The distance beyond a margin that is noted, shortest voxel edges. */
  private static final double NOTED_EDGES = 8;

  private final List<NearestApproach> approaches;

  /** The voxels within the margins of protected segments, as they were at first. */
  private final Optional<BitCube> kept;

  /**
   * Creates a scene of bits alone.
   *
   * @param volume the segments; once a session runs, its haptic thread alone changes their bits
   * @param settings solver, materials and limits
   */
  public ContactScene(SegmentedVolume volume, ContactSettings settings) {
    this(volume, settings, Optional.empty());
  }

  /**
   * Creates a scene with the grey values from which its one segment was made.
   *
   * @param volume the segments; once a session runs, its haptic thread alone changes their bits
   * @param settings solver, materials and limits
   * @param grey the isosurface for {@link SolverKind#SMOOTH}; if empty, the solver uses the bits
   */
  public ContactScene(
      SegmentedVolume volume, ContactSettings settings, Optional<GreyIsosurface> grey) {
    this(volume, List.of(), settings, grey);
  }

  /**
   * Creates a scene of bodies that stand where their placements say. Only rigid tools touch them
   * there; solvers of a point know no poses.
   *
   * @param volume the segments at rest; once a session runs, its haptic thread alone changes their
   *     bits
   * @param placements the placement of each segment, in their order; none if all stand at rest
   * @param settings solver, materials and limits
   * @param grey the isosurface for {@link SolverKind#SMOOTH}; if empty, the solver uses the bits
   */
  public ContactScene(
      SegmentedVolume volume,
      List<Placement> placements,
      ContactSettings settings,
      Optional<GreyIsosurface> grey) {
    this.placements = List.copyOf(placements);
    this.grey = grey.map(GreyIsosurfaceSource::new);
    this.volume = volume;
    this.settings = settings;
    Vec3 spacing = volume.grid().spacingMm();
    metric = GridMetric.of(spacing);
    maxStepMm = settings.maxStepMm().orElseGet(() -> ContactSettings.defaultMaxStepMm(spacing));
    edits = new EditQueue(volume.grid(), volume.segments().size());
    approaches = newApproaches();
    kept = settings.protectedMm().isEmpty() ? Optional.empty() : Optional.of(keptVoxels());
  }

  private List<NearestApproach> newApproaches() {
    List<NearestApproach> found = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      Double marginMm = settings.protectedMm().get(segment.name());
      if (marginMm != null) {
        double reachMm = marginMm + NOTED_EDGES * metric.shortestEdgeMm();
        BitCube bits = segment.bits();
        if (SegmentDistance.voxelsFor(bits, grid(), reachMm) <= SegmentDistance.MOST_VOXELS) {
          found.add(new NearestApproach(segment.name(), marginMm, bits, grid(), reachMm));
        }
      }
    }
    return found;
  }

  /**
   * {@return how near the frames of this scene came to each protected segment} One whose
   * neighbourhood is too large to keep is missing.
   */
  public List<NearestApproach> approaches() {
    return approaches;
  }

  private BitCube keptVoxels() {
    VoxelGrid grid = volume.grid();
    BitCube voxels = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (Segment segment : volume.segments()) {
      Double marginMm = settings.protectedMm().get(segment.name());
      if (marginMm != null) {
        GrownSolids.addNear(segment.bits(), metric, marginMm, voxels);
      }
    }
    return voxels;
  }

  /**
   * {@return the grid of the volume, which converts between world and grid coordinates} Positions
   * of the point and the tool are published in it, although bodies may have grids of their own.
   */
  public VoxelGrid grid() {
    return volume.grid();
  }

  /** {@return the volume with its segments} */
  public SegmentedVolume volume() {
    return volume;
  }

  /** {@return the settings that the scene was created with} */
  public ContactSettings settings() {
    return settings;
  }

  /** {@return the voxels within the margins of protected segments, if there are any; not copied} */
  public Optional<BitCube> protectedVoxels() {
    return kept;
  }

  /** {@return the metric of the grid, which measures lengths in millimetres} */
  public GridMetric metric() {
    return metric;
  }

  /** {@return w_max, the longest path of the interaction point in one frame, mm} */
  public double maxStepMm() {
    return maxStepMm;
  }

  /** {@return the grey isosurface that the smooth solver follows, if there is one} */
  public Optional<GreyIsosurface> grey() {
    return grey.map(GreyIsosurfaceSource::now);
  }

  /**
   * Queues new grey values for the smooth solver. Any thread.
   *
   * @param surface the new values, on the same grid
   * @return false if the queue of edits is full; then try again later
   * @throws IllegalStateException if the scene has no grey values
   */
  public boolean offerGrey(GreyIsosurface surface) {
    GreyIsosurfaceSource live =
        grey.orElseThrow(
            () ->
                new IllegalStateException(
                    "the scene has no grey values; create it with a GreyIsosurface"));
    return edits.offer(new GreyEdit(0, live, surface));
  }

  /** {@return the queue that takes changes of the segments while a session runs} Any thread. */
  public EditQueue edits() {
    return edits;
  }

  /** {@return the region and surface points that a simulated hand presses, world mm} */
  public HandTarget handTarget() {
    if (placements.isEmpty()) {
      return HandTargetFinder.of(volume);
    }
    List<Pose> poses = placements.stream().map(Placement::pose).toList();
    VoxelGrid around = PosedBits.gridAround(PosedBits.of(volume, poses), grid());
    return HandTargetFinder.of(PosedBits.resample(volume, poses, around));
  }

  /** Returns the source of the grey values, if there is one. */
  Optional<GreyIsosurfaceSource> greySource() {
    return grey;
  }

  /** {@return new bodies; see {@link #newBodies(Set)}} */
  public BodyScene newBodies() {
    return newBodies(Set.of());
  }

  /**
   * {@return new bodies, one for each segment in their order, which share the segments' voxels}
   *
   * @param movable the indices of those that can move; the others can move as the scene says
   */
  public BodyScene newBodies(Set<Integer> movable) {
    List<Body> bodies = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      int index = bodies.size();
      Placement placement = placements.isEmpty() ? AT_REST : placements.get(index);
      Mobility mobility = movable.contains(index) ? Mobility.MOVABLE : placement.mobility();
      VoxelGrid own = volume.grid(index);
      Body body = new Body(segment.name(), solids(segment, own), own, mobility);
      if (!placements.isEmpty()) {
        body.setPose(placement.pose());
      }
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }

  /** Returns the voxels that stop a tool: none of a segment that a needle may enter. */
  private BitCube solids(Segment segment, VoxelGrid own) {
    return material(segment).isPenetrable()
        ? new BitCube(own.sizeX(), own.sizeY(), own.sizeZ())
        : segment.bits();
  }

  private MaterialOverride material(Segment segment) {
    return settings.materials().getOrDefault(segment.name(), MaterialOverride.NONE);
  }

  /** {@return the segments that a needle may enter, by their names: those with a puncture force} */
  public Map<String, NeedleTissue> tissues() {
    Map<String, NeedleTissue> found = new LinkedHashMap<>();
    for (Segment segment : volume.segments()) {
      material(segment)
          .tissue(segment.bits())
          .ifPresent(tissue -> found.put(segment.name(), tissue));
    }
    return found;
  }

  /** {@return the placement of each segment; empty if all stand at rest} */
  public List<Placement> placements() {
    return placements;
  }

  /**
   * {@return a new collision scene in which each segment is one object} If segments are protected,
   * their margins are one more object, the last.
   */
  public CollisionScene newCollisionScene() {
    return new CollisionScene(
        Stream.concat(volume.segments().stream().map(Segment::bits), kept.stream()).toList());
  }

  /** {@return a new solver of the kind that the settings name} */
  public ProxySolver newSolver() {
    return newSolver(settings.solver());
  }

  /**
   * {@return a new solver} It uses the settings' collision method if it is of the settings' kind,
   * otherwise its own default.
   *
   * @param kind the algorithm that moves the point
   */
  public ProxySolver newSolver(SolverKind kind) {
    return kind.newSolver(this);
  }

  /**
   * {@return the stiffness for a device without a maximum of its own, N per mm of scan: 0.5 for
   * scenes from 32 mm to 1 m, more for smaller ones, so that these are felt as well, and less for
   * larger ones}
   */
  public double defaultStiffnessNewtonPerMm() {
    return ContactSettings.defaultStiffnessNewtonPerMm(grid());
  }

  /**
   * {@return stiffness, friction and damping of each segment}
   *
   * @param defaultNewtonPerMm stiffness if the settings give none, N per mm of scan
   */
  public ForceSettings force(double defaultNewtonPerMm) {
    return force(defaultNewtonPerMm, settings.frictionForm());
  }

  ForceSettings force(double defaultNewtonPerMm, FrictionForm form) {
    double newtonPerMm = settings.stiffnessNewtonPerMm().orElse(defaultNewtonPerMm);
    Material general = Material.of(newtonPerMm, settings.friction(), form);
    return new ForceSettings(general, form, true, materials(general, form));
  }

  /** Returns a material for each segment in their order, or none if all segments are alike. */
  private List<Material> materials(Material general, FrictionForm form) {
    Map<String, MaterialOverride> chosen = settings.materials();
    return volume.segments().stream().noneMatch(segment -> chosen.containsKey(segment.name()))
        ? List.of()
        : Stream.concat(
                volume.segments().stream().map(this::material),
                kept.stream().map(margins -> MaterialOverride.NONE))
            .map(choice -> choice.over(general, form))
            .toList();
  }

  /**
   * {@return the settings for the frames of a live session}
   *
   * @param device the device, which limits the force unless the settings do
   * @param defaultNewtonPerMm stiffness if the settings give none, N per mm of scan
   */
  public FrameSettings liveFrame(DeviceSpecification device, double defaultNewtonPerMm) {
    return liveFrame(device, force(defaultNewtonPerMm));
  }

  FrameSettings liveFrame(DeviceSpecification device, ForceSettings force) {
    FrameSettings live = FrameSettings.live(device, force);
    return settings.maxForceNewton().isPresent()
        ? live.withMaxForce(settings.maxForceNewton().getAsDouble())
        : live;
  }

  /**
   * {@return a new frame over this scene that applies its queued edits}
   *
   * @param gridDevice the device, converted to the grid of the scene
   * @param frame the settings of the frame
   * @param publisher receives the result of each frame on the haptic thread
   */
  public PointFrame newFrame(GridDevice gridDevice, FrameSettings frame, FramePublisher publisher) {
    PointFrame made =
        new PointFrame(
            gridDevice, newSolver(), newCollisionScene(), metric, frame, edits, publisher);
    carve().ifPresent(made::carve);
    made.watch(approaches);
    feel(made, frame);
    return made;
  }

  /** Gives a frame the effects, the mass and the grey materials of the settings. */
  private void feel(PointFrame made, FrameSettings frame) {
    made.requestEffects(newEffects(pointSite(frame)));
    settings
        .feel()
        .mass()
        .map(held -> new MassiveContact(metric, frame.force(), alongGrid(held)))
        .ifPresent(made::give);
    settings.feel().materials().ifPresent(made::use);
  }

  private MassSettings alongGrid(MassSettings held) {
    Vec3 gravity = held.gravityMmPerSecond2();
    return new MassSettings(held.kg(), grid().gridMmToWorld().inverseRotate(gravity, new Vec3()));
  }

  private EffectSite pointSite(FrameSettings frame) {
    double newtonPerMm = frame.force().stiffnessNewtonPerMm();
    return new EffectSite(
        grid().gridMmToWorld(), newtonPerMm, 0, frame.maxForceNewton(), List.of(new Vec3()));
  }

  /** Returns new effects of one frame. */
  List<HapticEffect> newEffects(EffectSite site) {
    return settings.feel().effects().stream().map(plan -> plan.make(site)).toList();
  }

  /** Returns how a tool cuts, if it does. */
  Optional<CarveSettings> carve() {
    return settings.carveMm3PerNewtonSecond().isPresent()
        ? Optional.of(
            new CarveSettings(
                settings.carveMm3PerNewtonSecond().getAsDouble(),
                volume.segments().stream().map(this::cutNewton).toList(),
                kept.orElse(null)))
        : Optional.empty();
  }

  private double cutNewton(Segment segment) {
    return material(segment).cutNewton();
  }

  /**
   * Returns a frame for the warm-up, which applies no edits and publishes nothing.
   *
   * @param hand moves in world mm
   * @param bodies makes elastic segments at rest, which the frame then updates too
   */
  PointFrame newWarmUpFrame(
      HapticDevice hand, FrameSettings frame, Optional<Supplier<ElasticBody>> bodies) {
    Optional<ElasticBody> body = bodies.map(Supplier::get);
    HapticDevice updating =
        body.<HapticDevice>map(soft -> new UpdatingDevice(hand, new SynchronousUpdates(soft)))
            .orElse(hand);
    EditQueue none = new EditQueue(volume.grid(), volume.segments().size(), 1);
    PointFrame made =
        new PointFrame(
            GridDevice.fromWorld(updating, grid()),
            newSolver(),
            newCollisionScene(),
            metric,
            frame,
            none,
            FramePublisher.NONE);
    feel(made, frame);
    body.ifPresent(soft -> made.deform(soft.contact()));
    return made;
  }

  /** Updates elastic segments between the frames of a warm-up, so that their code is compiled. */
  private static final class UpdatingDevice extends DeviceDecorator {
    /** Fewer updates than in a replay suffice, and leave time for frames. */
    private static final int READS_PER_FRAME = 8;

    private final SynchronousUpdates updates;
    private int reads;

    UpdatingDevice(HapticDevice device, SynchronousUpdates updates) {
      super(device);
      this.updates = updates;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      if (reads++ % READS_PER_FRAME == 0) {
        updates.beforeFrame();
      }
      return device.read(state);
    }
  }
}
