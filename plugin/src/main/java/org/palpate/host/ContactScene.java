package org.palpate.host;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.edit.EditQueue;
import org.palpate.edit.GreyEdit;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.Material;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.HapticFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * What can be touched and how: builds obstacles, solvers and frames out of a volume and settings.
 *
 * <p>Any thread builds; what is built belongs to the one that runs it.
 */
public final class ContactScene {
  private final SegmentedVolume volume;
  private final ContactSettings settings;
  private final GridMetric metric;
  private final double maxStepMm;
  private final EditQueue edits;
  private final Optional<GreyIsosurfaceSource> grey;

  /** A scene over a volume whose bits the haptic thread alone will change. */
  public ContactScene(SegmentedVolume volume, ContactSettings settings) {
    this(volume, settings, Optional.empty());
  }

  /**
   * The same with the grey values that its one segment was made of.
   *
   * @param grey what {@link SolverKind#SMOOTH} makes its surface of; of the bits where empty
   */
  public ContactScene(
      SegmentedVolume volume, ContactSettings settings, Optional<GreyIsosurface> grey) {
    this.grey = grey.map(GreyIsosurfaceSource::new);
    this.volume = volume;
    this.settings = settings;
    Vec3 spacing = volume.grid().spacingMm();
    metric = GridMetric.of(spacing);
    maxStepMm = settings.maxStepMm().orElseGet(() -> ContactSettings.defaultMaxStepMm(spacing));
    edits = new EditQueue(volume.grid(), volume.segments().size());
  }

  public VoxelGrid grid() {
    return volume.grid();
  }

  public SegmentedVolume volume() {
    return volume;
  }

  public ContactSettings settings() {
    return settings;
  }

  public GridMetric metric() {
    return metric;
  }

  /** w_max, the most that the interaction point travels in a frame, mm. */
  public double maxStepMm() {
    return maxStepMm;
  }

  /** The grey values that the smooth solver goes by, if any. */
  public Optional<GreyIsosurface> grey() {
    return grey.map(GreyIsosurfaceSource::now);
  }

  /**
   * Queues other grey values for the smooth solver; any thread.
   *
   * @return false where the queue of edits is full; try again later
   * @throws IllegalStateException where the scene was made without
   */
  public boolean offerGrey(GreyIsosurface fresh) {
    GreyIsosurfaceSource live =
        grey.orElseThrow(() -> new IllegalStateException("made without grey values"));
    return edits.offer(new GreyEdit(0, live, fresh));
  }

  /** Where changes of the segments are queued while a session runs. */
  public EditQueue edits() {
    return edits;
  }

  /** What a simulated hand goes for, world mm. */
  public HandTarget handTarget() {
    return HandTargetFinder.of(volume);
  }

  /** All segments as one obstacle each. */
  public CollisionScene newObstacles() {
    List<BitCube> cubes = volume.segments().stream().map(Segment::bits).toList();
    return new CollisionScene(cubes);
  }

  /** A solver as the settings want it. */
  public ProxySolver newSolver() {
    return newSolver(settings.solver());
  }

  /** Another solver; it finds collisions as the settings' solver does, or by its own default. */
  public ProxySolver newSolver(SolverKind kind) {
    CollisionChoice collision =
        kind == settings.solver() ? settings.collision() : kind.defaultCollision();
    BorderVoxels border = BorderVoxels.onTheFly();
    return switch (kind) {
      case GUARDED -> new GuardedSolver(metric, maxStepMm);
      case SMOOTH ->
          grey.map(values -> new SmoothSolver(metric, maxStepMm, values))
              .orElseGet(() -> new SmoothSolver(metric, maxStepMm));
      case DOT -> new DotSolver(newCaster(collision), metric, maxStepMm, border);
      case PAPER -> new PaperSolver(newCaster(collision), metric, maxStepMm, border);
      case NONE -> new CollisionOnlySolver(newCaster(collision), metric);
    };
  }

  private static RayCaster newCaster(CollisionChoice collision) {
    return switch (collision.method()) {
      case SAMPLED -> new SampledRayCaster(collision.stepVoxels());
      case GRIDPLANES -> new GridPlanesRayCaster();
      case EXACT -> new ExactRayCaster();
    };
  }

  /**
   * Stiffness, friction and damping of each segment.
   *
   * @param defaultNewtonPerMm stiffness where the settings give none
   */
  public ForceSettings force(double defaultNewtonPerMm) {
    double newtonPerMm = settings.stiffnessNewtonPerMm().orElse(defaultNewtonPerMm);
    FrictionForm form = settings.frictionForm();
    Material general = Material.of(newtonPerMm, settings.friction(), form);
    return new ForceSettings(general, form, true, materials(general, form));
  }

  /** One a segment, in their order; none where all feel alike. */
  private List<Material> materials(Material general, FrictionForm form) {
    Map<String, MaterialOverride> chosen = settings.materials();
    return volume.segments().stream().noneMatch(segment -> chosen.containsKey(segment.name()))
        ? List.of()
        : volume.segments().stream()
            .map(segment -> chosen.getOrDefault(segment.name(), MaterialOverride.NONE))
            .map(choice -> choice.over(general, form))
            .toList();
  }

  /** The settings of a live session's frame with a device. */
  public FrameSettings liveFrame(DeviceSpecification device, double defaultNewtonPerMm) {
    FrameSettings live = FrameSettings.live(device, force(defaultNewtonPerMm));
    return settings.maxForceNewton().isPresent()
        ? live.withMaxForce(settings.maxForceNewton().getAsDouble())
        : live;
  }

  /**
   * A frame over this scene that carries out its edits.
   *
   * @param gridDevice delivers grid coordinates, takes forces along the grid's axes
   */
  public HapticFrame newFrame(
      HapticDevice gridDevice, FrameSettings frame, FramePublisher publisher) {
    return new HapticFrame(
        gridDevice, newSolver(), newObstacles(), metric, frame, edits, publisher);
  }

  /** A frame that edits nothing and tells no one, to warm up with. */
  HapticFrame newWarmUpFrame(HapticDevice gridDevice, FrameSettings frame) {
    EditQueue none = new EditQueue(volume.grid(), volume.segments().size(), 1);
    return new HapticFrame(
        gridDevice, newSolver(), newObstacles(), metric, frame, none, FramePublisher.NONE);
  }
}
