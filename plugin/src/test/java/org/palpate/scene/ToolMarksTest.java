package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class ToolMarksTest {
  private static final RigidTransform POSE =
      new RigidTransform(
          new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(10, 20, 30));

  @Test
  void pointsLieWhereTheToolPosePutsThem() {
    ToolMarks marks = marks(List.of(new Vec3(5, 6, 7)), new Vec3());
    Vec3 expected = WorldAxes.UNKNOWN.toSceneOrBack(new Vec3(10, 22, 30), new Vec3());
    assertEquals(0, expected.sub(marks.points().get(0), new Vec3()).length(), 1e-12);
    assertTrue(marks.torqueArc().isEmpty(), "no torque, no arc");
    Vec3 contact = WorldAxes.UNKNOWN.toSceneOrBack(new Vec3(5, 6, 7), new Vec3());
    assertTrue(contact.sameBits(marks.contacts().get(0)));
  }

  @Test
  void theArcTurnsAboutTheReferencePointAsTheTorqueDoesAndGrowsWithIt() {
    Vec3 torque = new Vec3(0, 0, 5);
    List<Vec3> arc = arc(torque);
    Vec3 turned = new Vec3();
    for (int n = 0; n + 1 < arc.size(); n++) {
      Vec3 a = arc.get(n).sub(POSE.origin(), new Vec3());
      Vec3 b = arc.get(n + 1).sub(POSE.origin(), new Vec3());
      turned.z += a.x * b.y - a.y * b.x;
      assertEquals(0, a.z, 1e-12);
      assertEquals(2.4, a.length(), 1e-12);
    }
    assertTrue(turned.z > 0, "turned by " + turned);
    assertTrue(arc(torque.mul(2, new Vec3())).size() > arc.size());
    assertEquals(arc(new Vec3(0, 0, 1e3)).size(), arc(new Vec3(0, 0, 1e4)).size(), "is bounded");
  }

  /** Returns the arc in the world. */
  private static List<Vec3> arc(Vec3 torque) {
    return marks(List.of(), torque).torqueArc().stream()
        .map(point -> WorldAxes.UNKNOWN.toSceneOrBack(point, new Vec3()))
        .toList();
  }

  private static ToolMarks marks(List<Vec3> contactsMm, Vec3 torque) {
    return ToolMarks.at(List.of(new Vec3(2, 0, 0)), POSE, contactsMm, torque, WorldAxes.UNKNOWN);
  }
}
