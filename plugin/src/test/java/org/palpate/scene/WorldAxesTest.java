package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class WorldAxesTest {
  @Test
  void theSceneFrameIsLeftPosteriorSuperiorForEveryWorld() {
    Vec3 left = new Vec3(1, 0, 0);
    assertEquals(1, WorldAxes.LPS.toSceneOrBack(left, new Vec3()).x);
    assertEquals(-1, WorldAxes.RAS.toSceneOrBack(left, new Vec3()).x);
    assertEquals(-1, WorldAxes.LAS.toSceneOrBack(new Vec3(0, 1, 0), new Vec3()).y);
  }

  @Test
  void onlyALeftHandedWorldMirrors() {
    RigidTransform pose = RigidTransform.identity();
    assertTrue(WorldAxes.LAS.toScene(pose).isMirrored());
    assertFalse(WorldAxes.RAS.toScene(pose).isMirrored());
    assertFalse(WorldAxes.LPS.toScene(pose).isMirrored());
  }

  @Test
  void everyStandardViewHasUprightLetters() {
    assertEquals("L", WorldAxes.letter(0, true));
    assertEquals("A", WorldAxes.letter(1, false));
    assertEquals("H", WorldAxes.letter(2, true));
    Camera front = Camera.seeing(new Vec3(), List.of(), StandardView.FRONT, 1);
    assertEquals(1, front.right().x, 1e-12, "the patient's left is on the right");
    assertEquals(1, front.up().z, 1e-12);
    Camera back = Camera.seeing(new Vec3(), List.of(), StandardView.BACK, 1);
    assertEquals(-1, back.right().x, 1e-12);
    Camera foot = Camera.seeing(new Vec3(), List.of(), StandardView.FOOT, 1);
    assertEquals(1, foot.right().x, 1e-12, "as radiologists look: from the foot");
    assertEquals(-1, foot.up().y, 1e-12);
  }
}
