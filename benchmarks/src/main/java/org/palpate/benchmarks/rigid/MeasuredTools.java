package org.palpate.benchmarks.rigid;

import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;

/**
 * Makes tools that have about a given number of sample points, with the cover radius that commands
 * use.
 */
final class MeasuredTools {
  /**
   * The cover radius of tools that are made from shapes, for voxels of 1 mm; see {@code --tool}.
   */
  static final double COVER_MM = 0.498;

  /** The distance of neighbouring samples on the face of a box, mm. */
  private static final double STEP_MM = COVER_MM * Math.sqrt(2);

  /** Keeps the number of cells of an edge from being rounded up. */
  private static final double SHORTER = 1 - 1e-9;

  private MeasuredTools() {}

  /** Returns a cube with about {@code points} samples: 6 c^2 + 2 for c cells along an edge. */
  static RigidTool cube(int points) {
    double edgeMm = edgeMm(Math.sqrt((points - 2) / 6.0));
    return ToolSampler.ofShape(new BoxShape(edgeMm, edgeMm, edgeMm), COVER_MM);
  }

  /** Returns a thin plate, each of whose two faces has about {@code points} samples. */
  static RigidTool plate(int points) {
    double edgeMm = edgeMm(Math.sqrt(points) - 1);
    return ToolSampler.ofShape(new BoxShape(edgeMm, edgeMm, edgeMm(1)), COVER_MM);
  }

  private static double edgeMm(double cells) {
    return Math.round(cells) * STEP_MM * SHORTER;
  }

  /** Returns the radius of the smallest ball that has at least {@code points} samples, mm. */
  static double ballRadiusMm(int points) {
    double radiusMm = 1;
    while (ball(radiusMm).count() < points) {
      radiusMm += 0.05;
    }
    return radiusMm;
  }

  /** Returns a ball. */
  static RigidTool ball(double radiusMm) {
    return ToolSampler.ofShape(RodShape.sphere(radiusMm), COVER_MM);
  }
}
