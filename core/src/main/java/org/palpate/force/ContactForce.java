package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;

/**
 * Computes the force on the hand: virtual coupling, damping and friction.
 *
 * <p>The coupling k(p-d) pulls the hand back to the interaction point. The height of the solver's
 * surface is subtracted from |p-d|. Friction acts against the slide of the point. Stiffness,
 * friction and damping are those of the touched object, see {@link MaterialTransition}. If the
 * solver asks for it, {@link ForceRateLimit} keeps the coupling force from jumping.
 *
 * <p>Source: Vlasov et al. 2013, section 5.1, equations (3) and (4). Zero where the equations are
 * undefined. Haptic thread; allocates nothing.
 */
public final class ContactForce {
  private final GridMetric metric;
  private ForceSettings settings;
  private final MaterialTransition material;
  private final ForceRateLimit rateLimit;
  private final ContactDamping damping;
  private final ConeFriction coneFriction;
  private final Vec3 lastHand = new Vec3();
  private final Vec3 dampingForce = new Vec3();
  private final Vec3 slide = new Vec3();
  private double slideLengthMm;
  private boolean damps;

  /** Null if materials do not follow from grey values. */
  private GreyMaterials greys;

  private long frictionSkipped;

  /**
   * Makes the force of a session.
   *
   * @param metric measures all lengths
   * @param settings materials, friction and damping at the start
   */
  public ContactForce(GridMetric metric, ForceSettings settings) {
    this.metric = metric;
    this.settings = settings;
    damps = settings.damps();
    material = new MaterialTransition(metric.shortestEdgeMm(), settings.general());
    rateLimit = new ForceRateLimit(metric.shortestEdgeMm());
    damping = new ContactDamping(metric);
    coneFriction = new ConeFriction(metric);
  }

  /** {@return the present settings} */
  public ForceSettings settings() {
    return settings;
  }

  /** {@return the stiffness of the coupling in the last frame, N/mm} */
  public double stiffnessNewtonPerMm() {
    return material.stiffnessNewtonPerMm();
  }

  /**
   * Changes the settings from the next frame on.
   *
   * @param newSettings the new materials and the form of friction
   */
  @SuppressWarnings("ReferenceEquality") // each frame asks, nearly always with the same object
  public void change(ForceSettings newSettings) {
    if (settings != newSettings) {
      settings = newSettings;
      damps = newSettings.damps() || (greys != null && greys.damps());
      material.reset();
    }
  }

  /**
   * Takes materials from grey values instead of the settings; before the first frame.
   *
   * @param materials belong to a volume on the grid of the session
   */
  public void use(GreyMaterials materials) {
    greys = materials;
    damps |= materials.damps();
  }

  /** {@return the number of frames that skipped friction because it is zero} */
  public long frictionSkipped() {
    return frictionSkipped;
  }

  /**
   * Computes the force of a frame in which no time passed. Damping then keeps its last speed.
   *
   * @param point where the solver left it, with the legs of this frame
   * @param device d, grid coordinates
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint point, Vec3 device, Vec3 forceNewton) {
    compute(point, device, 0, forceNewton);
  }

  /**
   * Computes the force of a frame, without the limits of the device.
   *
   * @param point where the solver left it, with the legs of this frame and the touched object
   * @param device d, grid coordinates
   * @param elapsedNanos time since the last computed frame
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint point, Vec3 device, long elapsedNanos, Vec3 forceNewton) {
    compute(point, device, device, elapsedNanos, forceNewton);
  }

  /**
   * Computes the force of a frame, where the point is in other coordinates than the hand.
   *
   * @param point where the solver left it, with the legs of this frame and the touched object
   * @param device the point plus the stretch of the coupling, grid coordinates
   * @param hand the device position whose motion counts, grid coordinates
   * @param elapsedNanos time since the last computed frame
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(
      InteractionPoint point, Vec3 device, Vec3 hand, long elapsedNanos, Vec3 forceNewton) {
    material.advance(elapsedNanos);
    rateLimit.advance(elapsedNanos);
    coneFriction.advance(elapsedNanos);
    computeStretch(point, device, forceNewton);
    updateMaterial(point, device, hand, forceNewton.length());
    forceNewton.mul(material.stiffnessNewtonPerMm(), forceNewton);
    limitRate(point, hand, forceNewton);
    if (damps) {
      computeDamping(hand, elapsedNanos, forceNewton);
    }
    addFriction(point, hand, forceNewton);
    if (damps) {
      forceNewton.add(dampingForce, forceNewton);
    }
    lastHand.set(hand);
  }

  /** Writes the stretch of the virtual coupling into {@code dest}, mm. */
  private void computeStretch(InteractionPoint point, Vec3 device, Vec3 dest) {
    dest.set(
        (point.position.x - device.x) * metric.spacingX(),
        (point.position.y - device.y) * metric.spacingY(),
        (point.position.z - device.z) * metric.spacingZ());
    double heightMm = point.surfaceHeightMm;
    if (heightMm > 0) {
      double length = dest.length();
      dest.mul(length > heightMm ? (length - heightMm) / length : 0, dest);
    }
  }

  private void updateMaterial(InteractionPoint point, Vec3 device, Vec3 hand, double stretchMm) {
    if (greys != null) {
      double grey = point.contact ? greys.greyUnder(point, device, metric) : 0;
      material.follow(settings, greys, grey, point.contact, stretchMm, motionMm(hand));
      return;
    }
    double motionMm = settings.distinguishesObjects() ? motionMm(hand) : 0;
    material.follow(settings, point.touchedObject, point.contact, stretchMm, motionMm);
  }

  private void limitRate(InteractionPoint point, Vec3 hand, Vec3 coupling) {
    if (point.limitsForceRate) {
      rateLimit.limit(coupling, material.stiffnessNewtonPerMm(), motionMm(hand));
    } else {
      rateLimit.reset();
    }
  }

  /** Returns the motion of the hand since the last frame. */
  private double motionMm(Vec3 hand) {
    return metric.distance(lastHand.x, lastHand.y, lastHand.z, hand.x, hand.y, hand.z);
  }

  private void computeDamping(Vec3 hand, long elapsedNanos, Vec3 coupling) {
    damping.update(hand, elapsedNanos);
    damping.compute(coupling, material.dampingNewtonSecondPerMm(), dampingForce);
  }

  private void addFriction(InteractionPoint point, Vec3 hand, Vec3 force) {
    if (settings.form() == FrictionForm.CONE) {
      coneFriction.add(point, hand, material, force);
    } else if (settings.skipsFriction() && material.slidingFriction() == 0) {
      frictionSkipped++;
    } else {
      addSlidingFriction(point.legs, force);
    }
  }

  private void addSlidingFriction(LegPath legs, Vec3 force) {
    boolean slid = sumSlide(legs);
    if (!slid && settings.skipsFriction()) {
      frictionSkipped++;
      return;
    }
    double length = slide.length();
    if (!(length > 0) || !(legs.lengthMm() > 0)) {
      return;
    }
    slide.set(slide.x / length, slide.y / length, slide.z / length);
    double newton =
        material.slidingFriction()
            * pressingNewton(force, slide)
            * (slideLengthMm / legs.lengthMm());
    force.set(force.x - newton * slide.x, force.y - newton * slide.y, force.z - newton * slide.z);
  }

  /**
   * Writes the sum of the legs along surfaces, v_bv of the paper, and their length, w_bv, mm.
   *
   * <p>It also returns whether any leg slid: a loop of its own for that would cost as much as
   * skipping friction saves.
   */
  private boolean sumSlide(LegPath legs) {
    slide.set(0, 0, 0);
    slideLengthMm = 0;
    boolean slid = false;
    for (int leg = 0; leg < legs.count(); leg++) {
      if (legs.slid(leg)) {
        slid = true;
        slide.x += (legs.end(leg, 0) - legs.start(leg, 0)) * metric.spacingX();
        slide.y += (legs.end(leg, 1) - legs.start(leg, 1)) * metric.spacingY();
        slide.z += (legs.end(leg, 2) - legs.start(leg, 2)) * metric.spacingZ();
        slideLengthMm += legs.lengthMm(leg);
      }
    }
    return slid;
  }

  /** Returns |Fc.n|, with n the normal to the slide in the plane of slide and coupling force. */
  private double pressingNewton(Vec3 coupling, Vec3 slideDirection) {
    double along = Math.abs(coupling.dot(slideDirection));
    double whole = coupling.length();
    if (settings.form() == FrictionForm.SHORTER) {
      return Math.max(0, whole - along);
    }
    return Math.sqrt(Math.max(0, (whole - along) * (whole + along)));
  }
}
