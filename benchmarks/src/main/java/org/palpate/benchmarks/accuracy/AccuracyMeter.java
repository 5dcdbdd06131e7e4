package org.palpate.benchmarks.accuracy;

import org.palpate.collision.CollisionScene;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.phantom.AnalyticSurface;

/** Lets a solver follow a trajectory and measures its coupling force without friction. */
public final class AccuracyMeter {
  private final AnalyticSurface truth;
  private final GridMetric metric;
  private final SlideTrajectory trajectory;
  private final double depthMm;
  private final Vec3 deviceMm = new Vec3();
  private final Vec3 deviceGrid = new Vec3();
  private final Vec3 pointMm = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 lastNormal = new Vec3();
  private final Vec3 force = new Vec3();
  private final Vec3 lastForce = new Vec3();

  private int frames;
  private int lost;
  private double squaredAngles;
  private double worstAngle;
  private double heights;
  private double squaredHeights;
  private double lengths;
  private double squaredChanges;
  private double squaredTrueChanges;

  /** Creates a meter for one trajectory at one depth; the true surface is in millimetres. */
  public AccuracyMeter(
      AnalyticSurface truth, GridMetric metric, SlideTrajectory trajectory, double depthMm) {
    this.truth = truth;
    this.metric = metric;
    this.trajectory = trajectory;
    this.depthMm = depthMm;
  }

  /** Lets the solver follow all frames and measures those of the slide. */
  public Accuracy measure(ProxySolver solver, CollisionScene scene) {
    clear();
    InteractionPoint point = new InteractionPoint();
    ContactForce contact = new ContactForce(metric, ForceSettings.of(1, 0));
    solver.reset();
    point.position.set(toGrid(trajectory.device(0, deviceMm), deviceGrid));
    for (int frame = 0; frame < trajectory.frames(); frame++) {
      toGrid(trajectory.device(frame, deviceMm), deviceGrid);
      trajectory.normal(frame, normal);
      solver.follow(scene, deviceGrid, point);
      contact.compute(point, deviceGrid, force);
      if (frame >= trajectory.slideStart()) {
        count(point);
      }
      lastForce.set(force);
      lastNormal.set(normal);
    }
    return result();
  }

  private Vec3 toGrid(Vec3 mm, Vec3 dest) {
    return dest.set(mm.x / metric.spacingX(), mm.y / metric.spacingY(), mm.z / metric.spacingZ());
  }

  private void clear() {
    frames = 0;
    lost = 0;
    squaredAngles = worstAngle = heights = squaredHeights = lengths = 0;
    squaredChanges = squaredTrueChanges = 0;
  }

  private void count(InteractionPoint point) {
    frames++;
    double length = force.length();
    double angle = angleDegrees(force, normal);
    lost += length > 0 ? 0 : 1;
    squaredAngles += angle * angle;
    worstAngle = Math.max(worstAngle, angle);
    pointMm.set(
        point.position.x * metric.spacingX(),
        point.position.y * metric.spacingY(),
        point.position.z * metric.spacingZ());
    double height = truth.signedDistance(pointMm);
    heights += height;
    squaredHeights += height * height;
    lengths += length;
    squaredChanges += squaredDistance(force, lastForce);
    squaredTrueChanges += depthMm * depthMm * squaredDistance(normal, lastNormal);
  }

  /**
   * Returns the angle between a force and the true normal, degrees; 180 without a force.
   *
   * @param normal unit
   */
  public static double angleDegrees(Vec3 force, Vec3 normal) {
    double length = force.length();
    double cosine = length > 0 ? force.dot(normal) / length : -1;
    return StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
  }

  private static double squaredDistance(Vec3 a, Vec3 b) {
    double x = a.x - b.x;
    double y = a.y - b.y;
    double z = a.z - b.z;
    return x * x + y * y + z * z;
  }

  private Accuracy result() {
    double mean = heights / frames;
    double trueChange = Math.sqrt(squaredTrueChanges / frames);
    boolean flat = trueChange < 1e-9 * depthMm;
    return new Accuracy(
        Math.sqrt(squaredAngles / frames),
        worstAngle,
        mean,
        Math.sqrt(Math.max(0, squaredHeights / frames - mean * mean)),
        lengths / frames / depthMm,
        flat ? Double.POSITIVE_INFINITY : Math.sqrt(squaredChanges / frames) / trueChange,
        lost);
  }
}
