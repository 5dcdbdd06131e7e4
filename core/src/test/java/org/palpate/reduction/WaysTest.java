package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

class WaysTest {
  private static final RigidTool SHAPE =
      ToolSampler.ofSegment(BlockWithHole.PEG, BlockWithHole.GRID);

  @Test
  void aStraightWayKeepsItsEndsAndTheDistancesAskedFor() {
    List<Pose> way = List.of(new Pose(), Pose.at(0, 0, 20), Pose.at(0, 0, 40));
    List<Double> heights = heights(Ways.simplified(way, new double[] {1, 3}, SHAPE));
    assertEquals(4, heights.size(), heights.toString());
    assertEquals(0, heights.get(0));
    assertEquals(1, heights.get(1), 0.25);
    assertEquals(3, heights.get(2), 0.25);
    assertEquals(40, heights.get(3));
  }

  @Test
  void aBentWayKeepsItsBend() {
    List<Pose> way = new ArrayList<>();
    for (int n = 0; n <= 40; n++) {
      way.add(Pose.at(Math.max(0, n - 20), 0, Math.min(20, n)));
    }
    List<Pose> kept = Ways.simplified(way, new double[0], SHAPE);
    assertEquals(3, kept.size(), kept.toString());
    assertEquals(20, kept.get(1).translation.z, 0.3);
    assertEquals(0, kept.get(1).translation.x, 0.3);
  }

  @Test
  void countsTheStopsToADistance() {
    List<Pose> way = List.of(new Pose(), Pose.at(0, 0, 1), Pose.at(0, 0, 2), Pose.at(0, 0, 30));
    assertEquals(1, Ways.stopsTo(0.5, way, SHAPE));
    assertEquals(2, Ways.stopsTo(2, way, SHAPE));
    assertEquals(3, Ways.stopsTo(100, way, SHAPE), "no pose is so far");
    Vec3 up = Ways.direction(way, SHAPE);
    assertTrue(up.z > 1 - 1e-12, "leads up: " + up);
  }

  private static List<Double> heights(List<Pose> way) {
    return way.stream().map(pose -> pose.translation.z).toList();
  }
}
