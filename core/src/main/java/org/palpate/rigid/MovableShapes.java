package org.palpate.rigid;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/**
 * The sample points of the bodies that move, and the clearance that two bodies keep from each
 * other.
 *
 * @param shapes the sample points of each body in the order of the scene; null for one that stands
 *     still
 * @param marginMm the least gap between two bodies, mm; empty if only sample points keep out of the
 *     other's voxels
 */
public record MovableShapes(List<RigidTool> shapes, OptionalDouble marginMm) {

  /** Copies the list. */
  public MovableShapes {
    shapes = Collections.unmodifiableList(new ArrayList<>(shapes));
  }

  /**
   * {@return the shapes of a scene in which no body moves}
   *
   * @param scene the bodies
   */
  public static MovableShapes none(BodyScene scene) {
    return new MovableShapes(
        Collections.nCopies(scene.count(), (RigidTool) null), OptionalDouble.empty());
  }

  /**
   * {@return the shapes of all movable bodies, whose sample points keep out of voxels}
   *
   * @param scene the bodies; each that can move gets sample points
   */
  public static MovableShapes ofPoints(BodyScene scene) {
    return new MovableShapes(shapes(scene, 0), OptionalDouble.empty());
  }

  /**
   * {@return the shapes of all movable bodies} Whole solids keep out of each other, up to the
   * margin.
   *
   * @param scene the bodies; each that can move gets sample points
   * @param marginMm the least gap between two bodies, mm; negative if they may overlap by that
   *     depth
   * @throws org.palpate.rigid.tool.ErodedAwayException if a body has no part as deep as a negative
   *     margin
   */
  public static MovableShapes ofWholeBodies(BodyScene scene, double marginMm) {
    return new MovableShapes(
        shapes(scene, Math.max(0, -marginMm)), OptionalDouble.of(Math.max(0, marginMm)));
  }

  private static List<RigidTool> shapes(BodyScene scene, double depthMm) {
    List<RigidTool> shapes = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      Body body = scene.body(n);
      boolean moves = body.mobility() == Mobility.MOVABLE;
      shapes.add(moves ? shape(body, depthMm) : null);
    }
    return shapes;
  }

  private static RigidTool shape(Body body, double depthMm) {
    double edgeMm = longestEdgeMm(body, depthMm);
    return ToolSampler.ofErodedSegment(body.bits(), body.grid(), depthMm, edgeMm);
  }

  /**
   * Returns the longest edge of the voxels that are sampled, mm: the shortest edge of the body,
   * halved until it is at most half the depth.
   *
   * <p>Parts of one volume of cubes are then free where they fit. The grown solids of the other
   * part consist of cells that are as large as the sampled voxels, and the solid ones touch that
   * part. The erosion takes off all sampled voxels in their place, because the diagonal of a voxel
   * is less than the depth. This holds for depths from a quarter of the shortest edge on, because
   * an edge is cut into eight parts at most.
   */
  private static double longestEdgeMm(Body body, double depthMm) {
    if (depthMm == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double edgeMm = body.metric().shortestEdgeMm();
    while (edgeMm > 0.5 * depthMm) {
      edgeMm /= 2;
    }
    return edgeMm;
  }

  /**
   * {@return the memory that the shape of a movable body takes while it is made, bytes}
   *
   * @param body a body that can move
   * @param marginMm as for {@link #ofWholeBodies}
   */
  public static double bytesFor(Body body, double marginMm) {
    double edgeMm = longestEdgeMm(body, Math.max(0, -marginMm));
    return ToolSampler.bytesOfEdges(body.bits(), body.grid(), edgeMm);
  }

  /** Returns the clearance of sample points from a body. */
  Clearance clearance(RigidTool points, Body from) {
    return marginMm.isPresent()
        ? Clearance.ofWholeBody(points, from.grid(), marginMm.getAsDouble())
        : Clearance.POINTS;
  }
}
