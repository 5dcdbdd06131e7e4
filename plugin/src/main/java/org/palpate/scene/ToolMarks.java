package org.palpate.scene;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The drawing of a rigid tool in one frame: some of its sample points, the points in contact, and
 * the torque on the hand as an arc about the reference point. Scene frame, mm.
 *
 * @param points sample points at the tool pose
 * @param contacts the points in contact
 * @param torqueArc points along the arc, in the direction in which the torque turns the hand; empty
 *     if there is no torque
 */
public record ToolMarks(List<Vec3> points, List<Vec3> contacts, List<Vec3> torqueArc) {
  /** The most points that are drawn. */
  public static final int MOST_POINTS = 3000;

  private static final double RAD_PER_NEWTON_MM = 0.1;
  private static final double LARGEST_ARC_RAD = 1.6 * Math.PI;
  private static final double STEP_RAD = 0.1;
  private static final double LEAST_NEWTON_MM = 1e-3;

  /** Copies the lists. */
  public ToolMarks {
    points = List.copyOf(points);
    contacts = List.copyOf(contacts);
    torqueArc = List.copyOf(torqueArc);
  }

  /**
   * Returns the marks of a tool.
   *
   * @param toolPoints sample points, tool frame, mm
   * @param toolToWorld the tool pose
   * @param contactsMm the points in contact, world mm
   * @param torqueNewtonMm the torque on the hand about the reference point, world axes
   * @param axes the orientation of the world's axes
   */
  public static ToolMarks at(
      List<Vec3> toolPoints,
      RigidTransform toolToWorld,
      List<Vec3> contactsMm,
      Vec3 torqueNewtonMm,
      WorldAxes axes) {
    List<Vec3> points = new ArrayList<>();
    double radiusMm = 0;
    for (Vec3 point : toolPoints) {
      radiusMm = Math.max(radiusMm, point.length());
      Vec3 world = toolToWorld.transform(point, new Vec3());
      points.add(axes.toSceneOrBack(world, world));
    }
    List<Vec3> contacts =
        contactsMm.stream().map(contact -> axes.toSceneOrBack(contact, new Vec3())).toList();
    List<Vec3> arc = new ArrayList<>();
    if (torqueNewtonMm.length() > LEAST_NEWTON_MM) {
      addArc(toolToWorld.origin(), torqueNewtonMm, 1.2 * radiusMm, arc);
    }
    arc.forEach(point -> axes.toSceneOrBack(point, point));
    return new ToolMarks(points, contacts, arc);
  }

  /** Adds the arc in the world, so that a mirrored scene shows the torque mirrored too. */
  private static void addArc(Vec3 centre, Vec3 torque, double radiusMm, List<Vec3> arc) {
    double newtonMm = torque.length();
    Vec3 axis = torque.mul(1 / newtonMm, new Vec3());
    Vec3 helper = Math.abs(axis.z) < 0.7 ? new Vec3(0, 0, 1) : new Vec3(1, 0, 0);
    Vec3 u = axis.cross(helper, new Vec3());
    u.mul(radiusMm / u.length(), u);
    Vec3 v = axis.cross(u, new Vec3());
    double end = Math.min(RAD_PER_NEWTON_MM * newtonMm, LARGEST_ARC_RAD);
    int steps = Math.max(2, (int) Math.ceil(end / STEP_RAD));
    for (int n = 0; n <= steps; n++) {
      double angle = end * n / steps;
      Vec3 along = u.mul(Math.cos(angle), new Vec3());
      arc.add(along.add(v.mul(Math.sin(angle), new Vec3()), along).add(centre, along));
    }
  }
}
