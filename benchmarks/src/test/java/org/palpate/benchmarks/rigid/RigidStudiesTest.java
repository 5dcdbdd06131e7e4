package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

class RigidStudiesTest {
  private static final long SEED = 3;

  @Test
  void toolsHaveAboutTheNumberOfPointsThatTheirTablesName() {
    assertEquals(1_016, MeasuredTools.cube(1_000).count());
    assertEquals(5_048, MeasuredTools.cube(5_000).count());
    assertEquals(2 * 71 * 71, MeasuredTools.plate(5_000).count());
  }

  @Test
  void theAttackOnTheGuaranteeFindsNothing() {
    List<RigidFigure> figures =
        new GuaranteeStudy(300_000, 20_000, 400, SEED, line -> {}).figures();
    figures.forEach(figure -> assertTrue(!figure.verdict().equals("missed"), figure.toString()));
    assertTrue(value(figures, "legs judged") >= 300_000);
    assertTrue(value(figures, "frames judged for overlap") >= 400);
    assertTrue(value(figures, "frames with contact") > 5);
  }

  private static double value(List<RigidFigure> figures, String name) {
    return figures.stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow().value();
  }

  /**
   * With this hand, the rim of the peg first stands on voxels that are higher than the smooth
   * surface around them.
   */
  @Test
  void aPegEntersEveryHole() {
    List<RigidFigure> figures = new PegStudy(1, 10).figures();
    List<RigidFigure> failed = figures.stream().filter(f -> f.name().startsWith("failed")).toList();
    assertEquals(24, failed.size());
    failed.forEach(figure -> assertEquals("met", figure.verdict(), figure.toString()));
  }

  /** Without steps on faces of voxels, halves without a kerf stop at 4.07 and 8.64 mm. */
  @Test
  void twoHalvesFitAsFarAsALongSearchFindsOrNearly() {
    List<RigidFigure> figures = new HalvesStudy(7).figures();
    List<RigidFigure> residuals = figures.stream().filter(RigidStudiesTest::isResidual).toList();
    assertEquals(14, residuals.size());
    for (RigidFigure figure : residuals) {
      boolean isTight = figure.condition().equals("noise 2, no kerf, body");
      double most = isTight ? 3.7 : figure.target();
      assertTrue(figure.value() <= most, figure.toString());
    }
  }

  private static boolean isResidual(RigidFigure figure) {
    return figure.name().startsWith("residual") && figure.hasTarget();
  }

  /**
   * The device ends 3 mm below the first contact, so its spring of 1 N/mm pushes with at most 3 N.
   * Voxels may lie half a voxel higher than the plane, which adds 0.5 N.
   */
  @Test
  void thePenaltyMethodRestsWhereItsSpringsBalance() {
    SurfaceScene scene = SurfaceScene.of("plane", 96);
    Vec3 landing = new Vec3();
    Vec3 normal = new Vec3();
    scene.landing(landing, normal);
    RigidTool ball = MeasuredTools.ball(4);
    PenaltyPeer peer = new PenaltyPeer(scene.bodies().body(0).bits(), ball);
    Pose device = new Pose();
    normal.mul(8, device.translation).add(landing, device.translation);
    peer.place(device);
    for (int frame = 0; frame < 3_000; frame++) {
      double heightMm = Math.max(1, 8 - 0.01 * frame);
      normal.mul(heightMm, device.translation).add(landing, device.translation);
      peer.follow(device);
    }
    Vec3 force = peer.force(device, new Vec3());
    assertTrue(force.dot(normal) > 1 && force.dot(normal) < 3.5, "pushed out by " + force);
    assertTrue(force.dot(normal) > 0.9 * force.length(), "along the normal: " + force);
  }

  @Test
  void aFigureIsMetUpToItsTarget() {
    assertEquals("met", new RigidFigure("s", "c", "n", 2, "mm", 2).verdict());
    assertEquals("missed", new RigidFigure("s", "c", "n", 2.001, "mm", 2).verdict());
    assertEquals("missed", new RigidFigure("s", "c", "n", Double.NaN, "mm", 2).verdict());
    assertEquals("", RigidFigure.of("s", "c", "n", 2, "mm").verdict());
  }
}
