package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;

/**
 * Force on the hand: the virtual coupling k(p-d) that pulls it back to the interaction point, less
 * the height at which the solver's surface runs, and dry friction against the way that the point
 * slid. Where the solver asks for it the coupling hands over without a jump, see {@link
 * ForceRateLimit}. Stiffness, friction and damping are those of the object that is touched, see
 * {@link MaterialTransition}.
 *
 * <p>Source: Vlasov et al. 2013, section 5.1, equations (3) and (4). Zero where undefined. Haptic
 * thread; allocates nothing.
 */
public final class ContactForce {
  private final GridMetric metric;
  private ForceSettings settings;
  private final Vec3 slide = new Vec3();
  private final ForceRateLimit handOver;
  private final ConeFriction cone;
  private final MaterialTransition felt;
  private final ContactDamping damping;
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 outward = new Vec3();
  private boolean damps;
  private boolean pressed;
  private double slideLengthMm;
  private long frictionSkipped;

  /** Lengths are those of {@code metric}. */
  public ContactForce(GridMetric metric, ForceSettings settings) {
    this.metric = metric;
    this.settings = settings;
    damps = settings.damps();
    handOver = new ForceRateLimit(metric);
    cone = new ConeFriction(metric);
    damping = new ContactDamping(metric);
    double shortestMm = metric.shortestEdgeMm();
    felt = new MaterialTransition(shortestMm, settings.general());
  }

  public ForceSettings settings() {
    return settings;
  }

  /** Changes what the surface feels like from the next frame on. */
  @SuppressWarnings("ReferenceEquality") // asked every frame, and nearly always the same object
  public void change(ForceSettings newSettings) {
    if (settings != newSettings) {
      settings = newSettings;
      damps = newSettings.damps();
      pressed = false;
    }
  }

  /** Frames in which friction was left out because it is nothing. */
  public long frictionSkipped() {
    return frictionSkipped;
  }

  /**
   * Computes the force of a frame in which no time passed: one without damping.
   *
   * @param point where the solver left it, with the legs of this frame
   * @param device d, grid coordinates
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint point, Vec3 device, Vec3 forceNewton) {
    compute(point, device, 0, forceNewton);
  }

  /**
   * Computes the force of a frame, not limited.
   *
   * @param point where the solver left it, with the legs of this frame and what it touches
   * @param device d, grid coordinates
   * @param elapsedNanos since the last frame that was computed
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint point, Vec3 device, long elapsedNanos, Vec3 forceNewton) {
    stretch(point, device, forceNewton);
    feel(point, device, forceNewton.length());
    forceNewton.mul(felt.stiffnessNewtonPerMm(), forceNewton);
    handOver(point, device, forceNewton);
    double dampingNewton = damps ? damp(device, elapsedNanos, forceNewton) : 0;
    if (settings.form() == FrictionForm.CONE) {
      cone.add(point, device, felt, forceNewton);
    } else if (settings.skipsFriction() && felt.slidingFriction() == 0) {
      frictionSkipped++;
    } else {
      addFriction(point.legs, forceNewton);
    }
    if (damps) {
      outward.mul(dampingNewton, outward);
      forceNewton.add(outward, forceNewton);
    }
  }

  /** Chooses the material: at once where contact begins or all feel alike, else bit by bit. */
  private void feel(InteractionPoint point, Vec3 device, double stretchMm) {
    if (!settings.tellsObjectsApart()) {
      felt.set(settings.general());
    } else if (point.touched != InteractionPoint.NOTHING) {
      Material material = settings.material(point.touched);
      if (pressed) {
        felt.approach(material, stretchMm, motionMm(device));
      } else {
        felt.set(material);
      }
    }
    pressed = stretchMm > 0 && point.contact;
    lastDevice.set(device);
  }

  private double motionMm(Vec3 device) {
    return metric.distance(lastDevice.x, lastDevice.y, lastDevice.z, device.x, device.y, device.z);
  }

  /** Writes {@link #outward}, the direction of the coupling force; returns damping along it, N. */
  private double damp(Vec3 device, long elapsedNanos, Vec3 coupling) {
    damping.observe(device, elapsedNanos);
    double length = coupling.length();
    coupling.mul(length > 0 ? 1 / length : 0, outward);
    return damping.newton(coupling, felt.dampingNewtonSecondPerMm());
  }

  /** How often the coupling force was held back because the point jumped. */
  public long handOvers() {
    return handOver.events();
  }

  private void handOver(InteractionPoint point, Vec3 device, Vec3 force) {
    if (point.handsOver) {
      handOver.limit(force, device, felt.stiffnessNewtonPerMm());
    } else {
      handOver.forget();
    }
  }

  /** Writes the stretch of the coupling, mm. */
  private void stretch(InteractionPoint point, Vec3 device, Vec3 force) {
    force.set(
        (point.position.x - device.x) * metric.spacingX(),
        (point.position.y - device.y) * metric.spacingY(),
        (point.position.z - device.z) * metric.spacingZ());
    double heightMm = point.surfaceHeightMm;
    if (heightMm > 0) {
      double length = force.length();
      force.mul(length > heightMm ? (length - heightMm) / length : 0, force);
    }
  }

  private void addFriction(LegPath legs, Vec3 force) {
    boolean slid = sumSlide(legs); // one look at the legs for both: a second costs what it saves
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
        felt.slidingFriction() * pressing(force, slide) * (slideLengthMm / legs.lengthMm());
    force.set(force.x - newton * slide.x, force.y - newton * slide.y, force.z - newton * slide.z);
  }

  /** v_bv, the sum of the legs along surfaces, mm, and w_bv, their length; whether any slid. */
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

  /** |Fc.n|, n the normal to the slide in the plane of the slide and the coupling force. */
  private double pressing(Vec3 coupling, Vec3 slideDirection) {
    double along = Math.abs(coupling.dot(slideDirection));
    double whole = coupling.length();
    if (settings.form() == FrictionForm.SHORTER) {
      return Math.max(0, whole - along);
    }
    return Math.sqrt(Math.max(0, (whole - along) * (whole + along)));
  }
}
