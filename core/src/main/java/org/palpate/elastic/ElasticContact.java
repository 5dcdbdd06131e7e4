package org.palpate.elastic;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * The contact of an interaction point with elastic segments. The point stands in material
 * coordinates, where voxels never move. So an update carries it along, and every solver verifies
 * its legs as it does in a rigid scene.
 *
 * <p>In each frame the material gives way to the force by the answers of the newest field. The
 * solver then follows a device position in material coordinates. When a new field comes, the device
 * is shifted by as much as the field carries the point, so that the force makes no step; the shift
 * decays over some {@link #DECAY_FRAMES} frames of a millisecond, or as many more as frames are
 * shorter.
 *
 * <p>Haptic thread; allocates nothing after construction.
 */
public final class ElasticContact {
  /** The frames of a millisecond after which a shift has lost two thirds. */
  static final int DECAY_FRAMES = 20;

  private static final int BALANCE_STEPS = 2;
  private static final double NANOS_PER_MS = 1e6;

  private static final Vec3 ORIGIN = new Vec3();

  private final GridMetric metric;
  private final FieldExchange fields;
  private final ElasticLoad.Exchange loads;
  private final ChangedCells changed;
  private final DeformationMap map;

  /** The answer at {@link #position}, if {@link #pressed} and no other field is in use since. */
  private final LocalAnswer answer = new LocalAnswer();

  private final ElasticLoad load = new ElasticLoad();
  private final EnergyTank tank = new EnergyTank();
  private final SlideForecast forecast;

  /** The point after the last frame, material coordinates. */
  private final Vec3 position = new Vec3();

  /** The shift of the device, grid coordinates. */
  private final Vec3 shift = new Vec3();

  private final Vec3 device = new Vec3();
  private final Vec3 target = new Vec3();

  /** The position that the solver followed in the last frame, material coordinates. */
  private final Vec3 aim = new Vec3();

  private final Vec3 normal = new Vec3();
  private final Vec3 present = new Vec3();
  private final Vec3 coupled = new Vec3();
  private final Vec3 stretchMm = new Vec3();
  private final Vec3 reachMm = new Vec3();
  private final Vec3 forceNewton = new Vec3();
  private final Vec3 deviceMm = new Vec3();

  /** The part of the shift that a frame leaves. */
  private double keptShift = 1 - 1.0 / DECAY_FRAMES;

  /** Whether the point was kept from its device in the last frame. */
  private boolean pressed;

  /** Whether the last force on the material was clipped to the proof. */
  private boolean clipped;

  private long clippedFrames;
  private UpdateListener listener = UpdateListener.NONE;

  /** Creates a contact without a load. */
  ElasticContact(
      DeformationField.Layout layout,
      GridMetric metric,
      FieldExchange fields,
      ElasticLoad.Exchange loads,
      ChangedCells changed) {
    this.metric = metric;
    this.fields = fields;
    this.loads = loads;
    this.changed = changed;
    map = new DeformationMap(layout, fields.front());
    forecast = new SlideForecast(layout.finest());
  }

  /** Returns the map in use; for checks of the field after a frame. */
  DeformationMap map() {
    return map;
  }

  /**
   * Sets the pace of frames; call it before the first one. The pace is not measured, so that a
   * session replays to its bits.
   *
   * @param sampleNanos the usual time between two samples, ns; more than a millisecond counts as
   *     one
   * @return this contact
   */
  public ElasticContact paced(long sampleNanos) {
    double frameMs = sampleNanos / NANOS_PER_MS;
    keptShift = 1 - 1.0 / frames(DECAY_FRAMES, frameMs);
    forecast.paced(frameMs);
    return this;
  }

  /**
   * Returns the number of frames that take as long as a number of frames of a millisecond.
   *
   * @param frameMs the length of a frame, ms, positive; more than a millisecond counts as one
   */
  static int frames(int ofMillisecond, double frameMs) {
    return (int) Math.round(ofMillisecond / Math.min(1, frameMs));
  }

  /** Tells a listener which fields come into use. */
  void listen(UpdateListener newListener) {
    listener = newListener;
  }

  /** Returns the load that the last frame left; it belongs to the haptic thread. */
  ElasticLoad load() {
    return load;
  }

  /** Returns the point after the last frame, material coordinates. */
  Vec3 position() {
    return position;
  }

  /** {@return the device position of the last frame in material coordinates} */
  public Vec3 deviceAtRest() {
    return target;
  }

  /**
   * Notes an edit, after its writes.
   *
   * @param voxels holds every voxel that changed; not kept
   */
  public void edited(IntBox voxels) {
    changed.mark(voxels);
  }

  /**
   * Begins a frame: takes a new field, if there is one, and deforms the material by the force at
   * which it balances the coupling.
   *
   * @param deviceGrid where the device is, grid coordinates
   * @param point where the last frame left it, material coordinates
   * @param newtonPerMm the stiffness of the coupling
   * @return the device position in material coordinates, to read until the next frame
   */
  public Vec3 begin(Vec3 deviceGrid, InteractionPoint point, double newtonPerMm) {
    boolean isNew = fields.hasNew();
    if (isNew) {
      useNewField(point);
    }
    shift.mul(keptShift, shift);
    deviceGrid.add(shift, device);
    if (pressed) {
      if (isNew || !point.position.sameBits(position)) {
        map.answer(point.position, answer);
      }
      balance(point, newtonPerMm);
    }
    return map.inverse(device, target, target);
  }

  private void useNewField(InteractionPoint point) {
    map.forward(point.position, present);
    map.force(forceNewton);
    fields.take(); // From here on the updates may write the field that was in use.
    map.use(fields.front());
    map.slideTo(point.position);
    listener.used(fields.front().update);
    setForce(forceNewton.x, forceNewton.y, forceNewton.z);
    if (pressed) {
      map.forward(point.position, coupled);
      coupled.sub(present, coupled);
      shift.add(coupled, shift);
    }
  }

  private void setForce(double x, double y, double z) {
    clipped = map.setForce(x, y, z);
  }

  private void toMm(Vec3 from, Vec3 to, Vec3 dest) {
    dest.set(
        (to.x - from.x) * metric.spacingX(),
        (to.y - from.y) * metric.spacingY(),
        (to.z - from.z) * metric.spacingZ());
  }

  private void fromMm(Vec3 mm, Vec3 dest) {
    dest.set(mm.x / metric.spacingX(), mm.y / metric.spacingY(), mm.z / metric.spacingZ());
  }

  /** Forgets force and shift, because the point was placed anew; call it before {@link #follow}. */
  public void restart() {
    shift.set(0, 0, 0);
    pressed = false;
    forecast.restart();
    tank.restart();
  }

  /**
   * Moves the point after the device, and finds the force on the material.
   *
   * @param solver moves the point in material coordinates by verified legs
   * @param scene the solids, at rest in material coordinates
   * @param point the interaction point, material coordinates; moved
   * @param newtonPerMm the stiffness of the coupling, N/mm
   */
  public void follow(
      ProxySolver solver, CollisionScene scene, InteractionPoint point, double newtonPerMm) {
    if (pressed) {
      aimAtSurface(point);
    } else {
      aim.set(target);
    }
    solver.follow(scene, aim, point);
    point.limitsForceRate = true; // An update may turn the surface under a point of any solver.
    pressed = point.contact || !point.position.sameBits(aim);
    position.set(point.position);
    map.slideTo(position);
    if (pressed) {
      map.answer(position, answer);
      balance(point, newtonPerMm);
      findPresent(point);
    } else {
      setForce(0, 0, 0);
      map.forward(position, present);
    }
    couple(point);
    clippedFrames += clipped ? 1 : 0;
    forecast.follow(position, pressed, load.point);
    map.force(load.forceNewton);
    loads.write(load);
  }

  /**
   * Chooses a position in material coordinates for the solver to follow. It lies as far below the
   * surface as the device is from the present position, and aside by the pull along the surface. So
   * the point rests where the force is normal to the deformed surface.
   */
  private void aimAtSurface(InteractionPoint point) {
    Vec3 p = point.position;
    toMm(p, aim, normal); // The solver went to the point of the surface that is nearest to it.
    double length = normal.length();
    toMm(p, target, reachMm);
    if (length > 0) {
      normal.mul(1 / length, normal);
    }
    double depthMm = reachMm.dot(normal);
    findPresent(point);
    toMm(present, device, stretchMm);
    double lengthMm = stretchMm.length();
    if (!(depthMm > 0 && lengthMm > point.surfaceHeightMm)) {
      aim.set(target);
      return;
    }
    map.pullBack(p, stretchMm, stretchMm);
    normal.mul(lengthMm - stretchMm.dot(normal), normal);
    stretchMm.add(normal, stretchMm);
    fromMm(stretchMm, aim);
    aim.add(p, aim);
  }

  /**
   * Finds the force at which the spring from the present position and the material balance. The
   * spring is shorter than the way to the device by the height of the surface, in a direction that
   * the force turns; so each step uses the direction of the one before. The answer must be that of
   * the point.
   */
  private void balance(InteractionPoint point, double newtonPerMm) {
    for (int step = 0; step < BALANCE_STEPS; step++) {
      findPresent(point);
      toMm(present, device, stretchMm);
      double length = stretchMm.length();
      if (!(length > point.surfaceHeightMm)) {
        setForce(0, 0, 0);
        return;
      }
      toMm(point.position, device, reachMm);
      stretchMm.mul(point.surfaceHeightMm / length, stretchMm);
      reachMm.sub(stretchMm, reachMm);
      answer.balance(reachMm, newtonPerMm, forceNewton);
      setForce(forceNewton.x, forceNewton.y, forceNewton.z);
    }
  }

  /** Finds the present position of the point from its answer, without a search for its cell. */
  private void findPresent(InteractionPoint point) {
    map.displacementMm(answer, stretchMm);
    fromMm(stretchMm, present);
    present.add(point.position, present);
  }

  private void couple(InteractionPoint point) {
    if (!pressed && point.position.sameBits(target)) {
      coupled.set(point.position); // This avoids the rounding of a conversion and its inverse.
    } else {
      device.sub(present, coupled);
      coupled.add(point.position, coupled);
    }
  }

  /**
   * {@return the device position for the coupling, in material coordinates} Its offset from the
   * point equals the offset of the device from the present position of the point.
   */
  public Vec3 coupledDevice() {
    return coupled;
  }

  /**
   * Lowers the force on the hand if a press and release would otherwise return more work than it
   * took. Call it in each frame after {@link #follow}.
   *
   * @param deviceGrid where the device is, grid coordinates
   * @param point the interaction point, material coordinates
   * @param newtonPerMm the stiffness of the coupling
   * @param onHandNewton lowered in place
   */
  public void limitWork(
      Vec3 deviceGrid, InteractionPoint point, double newtonPerMm, Vec3 onHandNewton) {
    toMm(ORIGIN, deviceGrid, deviceMm);
    toMm(point.position, deviceGrid, reachMm);
    tank.limit(deviceMm, reachMm.length(), newtonPerMm, onHandNewton);
  }

  /** {@return the present position of the point, grid coordinates} */
  public Vec3 presentPosition() {
    return present;
  }

  /** {@return the number of frames whose force on the material was clipped to the proved forces} */
  public long clippedFrames() {
    return clippedFrames;
  }

  /** {@return the number of frames whose force on the hand {@link #limitWork} lowered} */
  public long loweredFrames() {
    return tank.loweredFrames();
  }
}
