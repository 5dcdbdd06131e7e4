package org.palpate.frame;

import java.util.Map;
import java.util.Optional;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.PointCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.edit.EditQueue;
import org.palpate.edit.ToolPlace;
import org.palpate.edit.VoxelWriter;
import org.palpate.elastic.ElasticContact;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.force.HandState;
import org.palpate.force.MassiveContact;
import org.palpate.force.guide.NearestApproach;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.TouchedObjectFinder;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * The frame of an interaction point on one grid. It reads and writes a {@link GridDevice}, so its
 * positions are grid coordinates and its forces act along the grid's axes. The torque is zero.
 *
 * <p>Threads are those of {@link HapticFrame}.
 */
public final class PointFrame extends HapticFrame {
  private final CollisionScene scene;
  private final GridMetric metric;
  private final EditQueue edits;
  private final VoxelWriter writer;
  private final FramePublisher publisher;
  private final NearestFreeVoxel nearestFreeVoxel;
  private final TouchedObjectFinder touchedObject = new TouchedObjectFinder();
  private final ContactForce contactForce;

  /** Sums what each former solver had skipped when the next one replaced it. */
  private final SkipCounters skippedByFormer = new SkipCounters();

  /** Sums what each later solver had already skipped when it came into use. */
  private final SkipCounters skippedBeforeUse = new SkipCounters();

  private final Vec3 deviceGrid = new Vec3();
  private final InteractionPoint point = new InteractionPoint();
  private ProxySolver solver;
  private boolean placed;

  /** The body that the solver follows instead of the device; null if there is none. */
  private MassiveContact massive;

  private final Vec3 followedGrid = new Vec3();

  /** Null if the point does not cut. */
  private PointCarver carver;

  /** Null if no segment is elastic. */
  private ElasticContact elastic;

  private volatile ForceSettings requestedForce;
  private volatile ProxySolver requestedSolver;

  /**
   * Makes a frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   * @param solver moves the interaction point; belongs to the frame from now on
   * @param scene the solids
   * @param metric the spacing of the scene's grid
   * @param settings materials, friction and limits
   * @param edits changes of the scene, applied before the point moves
   * @param publisher receives each frame's result
   */
  public PointFrame(
      GridDevice device,
      ProxySolver solver,
      CollisionScene scene,
      GridMetric metric,
      FrameSettings settings,
      EditQueue edits,
      FramePublisher publisher) {
    super(device.device(), settings);
    this.solver = solver;
    this.scene = scene;
    this.metric = metric;
    this.edits = edits;
    writer = new VoxelWriter(scene, (segment, voxels) -> noteEdit(voxels));
    writer.follow(new Place());
    this.publisher = publisher;
    nearestFreeVoxel = new NearestFreeVoxel(metric);
    contactForce = new ContactForce(metric, settings.force());
    requestedForce = settings.force();
    requestedSolver = solver;
  }

  /** The place of the interaction point, for edits. */
  private final class Place implements ToolPlace {
    @Override
    public boolean touchedPoint(int segment, Vec3 destGrid) {
      destGrid.set(point.position);
      return placed;
    }

    @Override
    public boolean devicePosition(int segment, Vec3 destGrid) {
      destGrid.set(elastic == null ? deviceGrid : elastic.deviceAtRest());
      return placed;
    }

    @Override
    public boolean gridToDevice(int segment, AffineMap dest) {
      return false;
    }

    @Override
    public boolean meets(int segment, int i, int j, int k) {
      return placed
          && holds(i, point.position.x)
          && holds(j, point.position.y)
          && holds(k, point.position.z);
    }

    private static boolean holds(int voxel, double coordinate) {
      return voxel <= coordinate && coordinate <= voxel + 1.0;
    }
  }

  @Override
  void applyRequests() {
    contactForce.change(requestedForce);
    if (massive != null) {
      massive.change(requestedForce);
    }
    ProxySolver requested = requestedSolver;
    if (requested != solver) {
      changeSolver(requested);
    }
  }

  private void changeSolver(ProxySolver next) {
    solver.addSkips(skippedByFormer);
    next.addSkips(skippedBeforeUse);
    solver = next;
    solver.reset();
    point.surfaceHeightMm = 0;
    point.limitsForceRate = false;
    freePointFromSolid(); // A baseline may have left it in a solid, where no other solver starts.
  }

  @Override
  void applyEdits(int maxVoxels) {
    edits.applyTo(writer, maxVoxels);
    if (!placed) {
      writer.clearChanged(); // The solver forgets everything when the point is placed.
    } else if (writer.hasChanged()) {
      resetAfterEdits();
      freePointFromSolid();
    }
  }

  /** Makes the solver forget what depends on voxels that changed, or all if grey values did. */
  private void resetAfterEdits() {
    if (writer.greyChanged()) {
      solver.reset();
    } else {
      solver.resetAfterEdit(writer.changed());
    }
    writer.clearChanged();
  }

  private void freePointFromSolid() {
    if (placed && touchesSolid()) {
      setFree(point.position);
    }
  }

  @Override
  void rest() {
    point.legs.clear();
  }

  @Override
  void follow() {
    deviceGrid.set(sample.positionMm);
    Vec3 device = deviceAtRest();
    if (!placed || sample.relocated) {
      placePoint(device);
    } else if (carver != null) {
      carve(device);
    }
    Vec3 followed = massive == null ? device : bodyFollowing(device);
    if (elastic == null) {
      solver.follow(scene, followed, point);
    } else {
      elastic.follow(solver, scene, point, stiffnessNewtonPerMm());
    }
    if (contactForce.settings().distinguishesObjects() || isObserved()) {
      touchedObject.find(scene, followed, point);
    }
  }

  /** Moves the body with mass after the device and returns its position. */
  private Vec3 bodyFollowing(Vec3 device) {
    massive.move(point, device, sinceForceNanos(), followedGrid);
    return followedGrid;
  }

  /** Returns the device position, in material coordinates if segments are elastic. */
  private Vec3 deviceAtRest() {
    return elastic == null ? deviceGrid : elastic.begin(deviceGrid, point, stiffnessNewtonPerMm());
  }

  private double stiffnessNewtonPerMm() {
    return contactForce.settings().material(point.touchedObject).stiffnessNewtonPerMm();
  }

  private void carve(Vec3 device) {
    if (carver.carve(point.position, device, pressingNewton(), sinceForceNanos())) {
      resetAfterEdits();
    }
  }

  private void noteEdit(IntBox voxels) {
    if (elastic != null) {
      elastic.edited(voxels);
    }
  }

  /**
   * Makes segments elastic. The point and its legs are then in material coordinates. Call it before
   * the first frame.
   *
   * @param contact belongs to the frame from now on
   */
  public void deform(ElasticContact contact) {
    elastic = contact;
  }

  @Override
  public VoxelWriter voxels() {
    return writer;
  }

  @Override
  public void carve(CarveSettings settings) {
    carver = new PointCarver(settings, scene, metric, edits.segments(), writer);
  }

  /**
   * Gives what the hand holds a mass from now on. Call it before the first frame, and not among
   * elastic segments.
   *
   * @param body belongs to the frame from now on
   */
  public void give(MassiveContact body) {
    massive = body;
  }

  /**
   * Takes materials from grey values from now on. Call it before the first frame, last.
   *
   * @param materials belong to volumes that nobody changes while frames run
   */
  public void use(GreyMaterials materials) {
    contactForce.use(materials);
    if (massive != null) {
      massive.use(materials);
    }
  }

  /** {@return what {@link #give} gave, if anything} */
  public Optional<MassiveContact> mass() {
    return Optional.ofNullable(massive);
  }

  /**
   * Places the point at the device, or as near to it as the solids permit. A device that jumped
   * begins a new chain of legs, as a point does that was set free.
   */
  private void placePoint(Vec3 device) {
    boolean jumped = placed;
    placed = true;
    point.position.set(device);
    solver.reset();
    if (touchesSolid()) {
      setFree(device);
    } else if (jumped) {
      beginAnew();
    } else {
      placeMass();
    }
  }

  private void placeMass() {
    if (massive != null) {
      massive.place(point.position);
    }
  }

  private boolean touchesSolid() {
    return scene.touches(point.position.x, point.position.y, point.position.z);
  }

  private void setFree(Vec3 from) {
    nearestFreeVoxel.find(scene, from, point.position);
    beginAnew();
  }

  /** Begins a new chain of legs at the present position, with a force that rises from zero. */
  private void beginAnew() {
    solver.reset();
    if (elastic != null) {
      elastic.restart();
    }
    placeMass();
    setFree();
  }

  @Override
  void computeForce(long sinceLastNanos) {
    if (massive != null) {
      massive.compute(point, forceNewton);
    } else if (elastic != null) {
      contactForce.compute(point, elastic.coupledDevice(), deviceGrid, sinceLastNanos, forceNewton);
      elastic.limitWork(deviceGrid, point, contactForce.stiffnessNewtonPerMm(), forceNewton);
    } else {
      contactForce.compute(point, deviceGrid, sinceLastNanos, forceNewton);
    }
    addEffects(sinceLastNanos);
  }

  @Override
  void describe(HandState dest) {
    toMillimetres(deviceGrid, dest.device.translation);
    toMillimetres(presentPosition(), dest.tool.translation);
  }

  @Override
  void describe(FrameRecord dest) {
    toMillimetres(deviceGrid, dest.deviceMm);
    toMillimetres(presentPosition(), dest.tool.translation);
    dest.take(point);
  }

  private void toMillimetres(Vec3 grid, Vec3 dest) {
    dest.set(grid.x * metric.spacingX(), grid.y * metric.spacingY(), grid.z * metric.spacingZ());
  }

  @Override
  boolean isTouching() {
    return point.contact;
  }

  @Override
  void note(long frame, NearestApproach dest) {
    dest.notePoint(point.position, frame);
  }

  @Override
  void publish(long frame) {
    publisher.publish(deviceGrid, presentPosition(), forceNewton, point.contact, frame);
  }

  /**
   * Changes materials and friction from the next frame on. Any thread.
   *
   * @param requested the new materials and the form of friction
   */
  public void requestForce(ForceSettings requested) {
    requestedForce = requested;
  }

  /**
   * Changes the solver from the next frame on. The solver then belongs to the frame. Any thread.
   *
   * @param requested a solver that no other frame uses
   */
  public void requestSolver(ProxySolver requested) {
    requestedSolver = requested;
  }

  /**
   * {@return where the interaction point is now, grid coordinates: its position, or, if segments
   * are elastic, where the deformation carries it} It belongs to the frame.
   */
  public Vec3 presentPosition() {
    return elastic == null ? point.position : elastic.presentPosition();
  }

  /** {@return the interaction point with the legs of the last frame} It belongs to the frame. */
  public InteractionPoint point() {
    return point;
  }

  /**
   * {@return the work of the last frame that followed the device, see {@link ProxySolver#steps}}
   */
  public long work() {
    return solver.steps();
  }

  @Override
  Map<String, Long> skipped() {
    SkipCounters all = new SkipCounters();
    all.add(skippedByFormer);
    solver.addSkips(all);
    all.subtract(skippedBeforeUse);
    scene.addSkips(all);
    all.add(SkipKind.FRICTION, contactForce.frictionSkipped());
    return all.byKey();
  }
}
