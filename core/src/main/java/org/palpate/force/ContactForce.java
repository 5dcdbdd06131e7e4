package org.palpate.force;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.Metric;

/**
 * Force on the hand: the virtual coupling k(p-d) that pulls it back to the interaction point, less
 * the height at which the solver's surface runs, and dry friction against the way that the point
 * slid. Where the solver asks for it the coupling hands over without a jump, see {@link
 * ForceHandOver}.
 *
 * <p>Source: Vlasov et al. 2013, section 5.1, equations (3) and (4). Zero where undefined. Haptic
 * thread; allocates nothing.
 */
public final class ContactForce {
  private final Metric metric;
  private ForceSettings settings;
  private final Vec3 slide = new Vec3();
  private final ForceHandOver handOver;
  private final ConeFriction cone;
  private double slideLengthMm;
  private long frictionSkipped;

  /** Lengths are those of {@code metric}. */
  public ContactForce(Metric metric, ForceSettings settings) {
    this.metric = metric;
    this.settings = settings;
    handOver = new ForceHandOver(metric);
    cone = new ConeFriction(metric);
  }

  public ForceSettings settings() {
    return settings;
  }

  /** Changes what the surface feels like from the next frame on. */
  public void change(ForceSettings newSettings) {
    settings = newSettings;
  }

  /** Frames in which friction was left out because it is nothing. */
  public long frictionSkipped() {
    return frictionSkipped;
  }

  /**
   * Computes the force of a frame, not limited.
   *
   * @param point where the solver left it, with the legs of this frame
   * @param device d, grid coordinates
   * @param forceNewton the result, newtons along the grid's axes
   */
  public void compute(InteractionPoint point, Vec3 device, Vec3 forceNewton) {
    couple(point, device, forceNewton);
    handOver(point, device, forceNewton);
    if (settings.form() == FrictionForm.CONE) {
      cone.add(point, device, settings, forceNewton);
    } else if (settings.skipsFriction() && isFrictionless(point.legs)) {
      frictionSkipped++;
    } else {
      addFriction(point.legs, forceNewton);
    }
  }

  /** How often the coupling force was held back because the point jumped. */
  public long handOvers() {
    return handOver.events();
  }

  private void handOver(InteractionPoint point, Vec3 device, Vec3 force) {
    if (point.handsOver) {
      handOver.limit(force, device, settings.stiffnessNewtonPerMm());
    } else {
      handOver.forget();
    }
  }

  private void couple(InteractionPoint point, Vec3 device, Vec3 force) {
    force.set(
        (point.position.x - device.x) * metric.spacingX(),
        (point.position.y - device.y) * metric.spacingY(),
        (point.position.z - device.z) * metric.spacingZ());
    double heightMm = point.surfaceHeightMm;
    double share = 1;
    if (heightMm > 0) {
      double length = force.length();
      share = length > heightMm ? (length - heightMm) / length : 0;
    }
    force.mul(settings.stiffnessNewtonPerMm() * share, force);
  }

  private boolean isFrictionless(LegPath legs) {
    return settings.friction() == 0 || !anySlid(legs);
  }

  private static boolean anySlid(LegPath legs) {
    for (int leg = 0; leg < legs.count(); leg++) {
      if (legs.slid(leg)) {
        return true;
      }
    }
    return false;
  }

  private void addFriction(LegPath legs, Vec3 force) {
    sumSlide(legs);
    double length = slide.length();
    if (!(length > 0) || !(legs.lengthMm() > 0)) {
      return;
    }
    slide.set(slide.x / length, slide.y / length, slide.z / length);
    double newton =
        settings.friction() * pressing(force, slide) * (slideLengthMm / legs.lengthMm());
    force.set(force.x - newton * slide.x, force.y - newton * slide.y, force.z - newton * slide.z);
  }

  /** v_bv, the sum of the legs along surfaces, mm, and w_bv, their length. */
  private void sumSlide(LegPath legs) {
    slide.set(0, 0, 0);
    slideLengthMm = 0;
    for (int leg = 0; leg < legs.count(); leg++) {
      if (legs.slid(leg)) {
        slide.x += (legs.end(leg, 0) - legs.start(leg, 0)) * metric.spacingX();
        slide.y += (legs.end(leg, 1) - legs.start(leg, 1)) * metric.spacingY();
        slide.z += (legs.end(leg, 2) - legs.start(leg, 2)) * metric.spacingZ();
        slideLengthMm += legs.lengthMm(leg);
      }
    }
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
