package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.MovableShapes;
import org.palpate.volume.BitCube;

class FragmentPlacesTest {
  private static final BitCube SMALL = PullSearchTest.box(6, 6, 6, 9, 9, 9);
  private static final BitCube LARGE = PullSearchTest.box(2, 2, 2, 14, 14, 14);

  private final BodyScene scene =
      new BodyScene(
          List.of(
              new Body("small", SMALL, BlockWithHole.GRID, Mobility.MOVABLE),
              new Body("large", LARGE, BlockWithHole.GRID, Mobility.MOVABLE)));

  private final FragmentPlaces places =
      new FragmentPlaces(scene, MovableShapes.ofPoints(scene).shapes());

  @Test
  void fragmentsMeetWhereTheyOverlapOrTouch() {
    assertTrue(meet(Pose.at(0, 0, 7)), "overlap");
    assertTrue(meet(Pose.at(0, 0, 8)), "share a face");
    assertFalse(meet(Pose.at(0, 0, 10)), "are two voxels apart");
  }

  @Test
  void aSmallFragmentInsideALargeOneMeetsIt() {
    assertTrue(places.meet(0, new Pose(), 1, new Pose()));
    assertTrue(places.meet(1, new Pose(), 0, new Pose()));
  }

  @Test
  void theFarthestPointDependsOnWhereTheFragmentIs() {
    Vec3 corner = new Vec3(6.5, 6.5, 6.5);
    assertEquals(Math.sqrt(12), places.farthestMm(0, corner), 1e-9);
    scene.body(0).setPose(Pose.at(0, 0, 10));
    assertEquals(Math.sqrt(4 + 4 + 144), places.farthestMm(0, corner), 1e-9);
  }

  private boolean meet(Pose small) {
    boolean meets = places.meet(0, small, 1, new Pose());
    assertEquals(meets, places.meet(1, new Pose(), 0, small), "either way");
    return meets;
  }
}
