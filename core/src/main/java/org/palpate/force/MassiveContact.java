package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/**
 * A body with mass between the device and the interaction point. A spring couples it to the device,
 * and another one to the point; the solver follows the body instead of the device. So the dynamics
 * only propose where the point goes.
 *
 * <p>Both springs in series are as stiff as the touched material. For the stiffest material, the
 * spring to the point is {@link #CONTACT_STIFFNESS_FACTOR} times as stiff as the material, so the
 * body hardly enters the surface. The height of the solver's surface is subtracted from the length
 * of that spring.
 *
 * <p>Each frame takes a step of the implicit Euler method while the point stays: the body goes to
 * the least sum of kinetic, spring, drag and gravity terms. Such a step never raises the energy by
 * more than the hand puts in. Then the solver moves the point, which only shortens the spring to
 * it. Friction shortens the step along the surface, to zero at most, and damping the step into it.
 * An {@link EnergyObserver} takes what surplus is left.
 *
 * <p>If device and point rest, and two steps in a row are shorter than {@link
 * MassSettings#REST_MM}, the body rests too, bit for bit.
 *
 * <p>References: Colgate, Stanley and Brown 1995 (virtual coupling); Brown and Colgate 1998 (mass).
 * Device, point and target in grid coordinates; inside, grid millimetres, mm/s and N. Haptic
 * thread; allocates nothing.
 */
public final class MassiveContact {
  /** The stiffness of the spring to the point over that of the stiffest material. */
  static final double CONTACT_STIFFNESS_FACTOR = 4;

  private final GridMetric metric;
  private final MassSettings held;
  private final double mass;
  private final Vec3 weightNewton;
  private final MaterialTransition material;
  private final EnergyObserver observer = new EnergyObserver();
  private ForceSettings settings;
  private double couplingStiffness;

  /** Null if materials do not follow from grey values. */
  private GreyMaterials greys;

  private final Vec3 body = new Vec3();
  private final Vec3 targetGrid = new Vec3();
  private final Vec3 velocity = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 device = new Vec3();
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 lastPoint = new Vec3();
  private final Vec3 step = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 scratch = new Vec3();
  private double lastStepMm;
  private boolean begun;

  /**
   * Creates the body of a session, at rest at the origin until {@link #place}.
   *
   * @param metric measures all lengths
   * @param settings materials and friction at the start
   * @param held the mass, with gravity along the grid's axes
   */
  public MassiveContact(GridMetric metric, ForceSettings settings, MassSettings held) {
    this.metric = metric;
    this.settings = settings;
    this.held = held;
    mass = held.newtonSecond2PerMm();
    weightNewton = held.weightNewton();
    material = new MaterialTransition(metric.shortestEdgeMm(), settings.general());
    couple();
  }

  /**
   * Changes stiffness and materials from the next frame on.
   *
   * @param newSettings the new materials
   */
  @SuppressWarnings("ReferenceEquality") // each frame asks, nearly always with the same object
  public void change(ForceSettings newSettings) {
    if (settings != newSettings) {
      settings = newSettings;
      material.reset();
      couple();
    }
  }

  /**
   * Takes materials from grey values instead of the settings; before the first frame.
   *
   * @param materials belong to a volume on the grid of the session
   */
  public void use(GreyMaterials materials) {
    greys = materials;
    couple();
  }

  private void couple() {
    double stiffest =
        greys == null
            ? settings.stiffestNewtonPerMm()
            : settings.stiffnessNewtonPerMm() * greys.stiffest();
    couplingStiffness = stiffest * CONTACT_STIFFNESS_FACTOR / (CONTACT_STIFFNESS_FACTOR - 1);
  }

  /**
   * Returns the stiffness of the spring to the point: both in series are as stiff as the material.
   */
  private double contactStiffness() {
    double wanted = material.stiffnessNewtonPerMm();
    double rest = couplingStiffness - wanted;
    return rest > 0 ? wanted * couplingStiffness / rest : 0;
  }

  /**
   * Puts the body at rest at a position, because the point was placed there.
   *
   * @param pointGrid where the point was placed, grid coordinates
   */
  public void place(Vec3 pointGrid) {
    toMillimetres(pointGrid, body);
    velocity.set(0, 0, 0);
    begun = false;
  }

  private void toMillimetres(Vec3 grid, Vec3 dest) {
    dest.set(grid.x * metric.spacingX(), grid.y * metric.spacingY(), grid.z * metric.spacingZ());
  }

  /**
   * Moves the body and writes where the solver is to bring the point.
   *
   * @param contact the point where the last frame left it
   * @param deviceGrid the device position, grid coordinates
   * @param elapsedNanos time since the last call; counts up to 5 ms
   * @param dest written, grid coordinates
   */
  public void move(InteractionPoint contact, Vec3 deviceGrid, long elapsedNanos, Vec3 dest) {
    toMillimetres(deviceGrid, device);
    toMillimetres(contact.position, point);
    material.advance(elapsedNanos);
    double seconds = MassSettings.stepSeconds(elapsedNanos);
    if (seconds > 0) {
      proposeStep(contact, seconds);
      double stepMm = step.length();
      if (stepMm < MassSettings.REST_MM && lastStepMm < MassSettings.REST_MM && areAtRest()) {
        step.set(0, 0, 0);
      }
      lastStepMm = stepMm;
      body.add(step, body);
      step.mul(1 / seconds, velocity);
      lastPoint.set(point);
    }
    writeTarget(deviceGrid);
    dest.set(targetGrid);
  }

  /** Writes the body's position; if a huge number has made it not finite, that of the device. */
  private void writeTarget(Vec3 deviceGrid) {
    targetGrid.set(
        body.x / metric.spacingX(), body.y / metric.spacingY(), body.z / metric.spacingZ());
    if (!targetGrid.isFinite() || !velocity.isFinite()) {
      targetGrid.set(deviceGrid);
      place(deviceGrid);
    }
  }

  private boolean areAtRest() {
    return begun && device.sameBits(lastDevice) && point.sameBits(lastPoint);
  }

  /** Writes the step of the body, mm. */
  private void proposeStep(InteractionPoint contact, double seconds) {
    double inertia = mass / (seconds * seconds);
    double drag = held.dragNewtonSecondPerMm(couplingStiffness) / seconds;
    double whole = inertia + drag + couplingStiffness;
    // Without the spring to the point, this step leads to the least energy.
    velocity.mul(inertia * seconds, step);
    step.add(device.sub(body, scratch).mul(couplingStiffness, scratch), step);
    step.add(weightNewton, step).mul(1 / whole, step);
    double stiffness = contactStiffness();
    double heightMm = Math.max(0, contact.surfaceHeightMm);
    body.add(step, normal).sub(point, normal);
    double lengthMm = normal.length();
    if (!(lengthMm > heightMm)) {
      return;
    }
    normal.mul(1 / lengthMm, normal);
    double stretchMm = (lengthMm - heightMm) * whole / (whole + stiffness);
    addAlong(normal, stretchMm + heightMm - lengthMm);
    if (contact.contact) {
      resist(stiffness * stretchMm, whole, stiffness, seconds);
    }
  }

  private void addAlong(Vec3 direction, double mm) {
    step.set(step.x + mm * direction.x, step.y + mm * direction.y, step.z + mm * direction.z);
  }

  /** Shortens the step: along the surface by friction, and across it by damping. */
  private void resist(double pressing, double whole, double stiffness, double seconds) {
    double across = step.dot(normal);
    double damping = material.dampingNewtonSecondPerMm() / seconds;
    double kept = (whole + stiffness) / (whole + stiffness + damping);
    addAlong(normal, -across);
    double alongMm = step.length();
    double staticMm = material.staticFriction() * pressing / whole;
    double slidingMm = material.slidingFriction() * pressing / whole;
    step.mul(alongMm > staticMm ? (alongMm - slidingMm) / alongMm : 0, step);
    addAlong(normal, kept * across);
  }

  /**
   * Computes the force of a frame, without the limits of the device, after the solver has moved the
   * point.
   *
   * @param contact where the solver left the point, with the touched object
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint contact, Vec3 forceNewton) {
    toMillimetres(contact.position, point);
    double motionMm = begun ? device.sub(lastDevice, scratch).length() : 0;
    double stretchMm =
        Math.max(0, body.sub(point, scratch).length() - Math.max(0, contact.surfaceHeightMm));
    if (greys != null) {
      double grey = contact.contact ? greys.greyUnder(contact, targetGrid, metric) : 0;
      material.follow(settings, greys, grey, contact.contact, stretchMm, motionMm);
    } else {
      material.follow(settings, contact.touchedObject, contact.contact, stretchMm, motionMm);
    }
    body.sub(device, forceNewton).mul(couplingStiffness, forceNewton);
    account(stretchMm, forceNewton);
    lastDevice.set(device);
    begun = true;
  }

  private void account(double stretchMm, Vec3 forceNewton) {
    double kinetic = 0.5 * mass * velocity.dot(velocity);
    double energy =
        kinetic
            + 0.5 * forceNewton.dot(forceNewton) / couplingStiffness
            + 0.5 * contactStiffness() * stretchMm * stretchMm
            - weightNewton.dot(body);
    double work = -forceNewton.dot(device.sub(lastDevice, scratch));
    if (begun && Double.isFinite(energy - work)) {
      velocity.mul(observer.account(kinetic, energy, work), velocity);
    } else {
      observer.begin(energy);
    }
  }

  /** {@return the mass, kg} */
  public double kg() {
    return held.kg();
  }

  /** {@return the surplus of energy that no motion has paid yet, mJ} */
  public double debtMillijoule() {
    return observer.debt();
  }

  /** {@return the surplus of energy that was taken from the motion of the body so far, mJ} */
  public double takenMillijoule() {
    return observer.taken();
  }
}
