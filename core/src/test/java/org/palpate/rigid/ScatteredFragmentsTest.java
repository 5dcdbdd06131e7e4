package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.phantom.FracturePhantom;

/** Judges voxel by voxel that fragments do not overlap where a fracture leaves them. */
class ScatteredFragmentsTest {
  @Test
  void noTwoDisplacedFragmentsOverlap() {
    for (int parts = 2; parts <= 8; parts++) {
      FracturePhantom phantom = new FracturePhantom(96, new FractureSpec(parts, 20 + parts, 1));
      Fragments fragments = phantom.fragments();
      List<Pose> poses = phantom.startPoses(fragments);
      for (int a = 0; a < parts; a++) {
        for (int b = 0; b < parts; b++) {
          assertFalse(a != b && overlap(fragments, poses, a, b), parts + ": " + a + " and " + b);
        }
      }
    }
  }

  @Test
  void theJudgeSeesAnOverlapIfAFragmentIsPutIntoAnother() {
    FracturePhantom phantom = new FracturePhantom(96, new FractureSpec(3, 1, 0));
    Fragments fragments = phantom.fragments();
    Pose shifted = new Pose();
    shifted.translation.set(-4, 0, 0);
    boolean either =
        overlap(fragments, List.of(new Pose(), shifted, new Pose()), 1, 0)
            || overlap(fragments, List.of(new Pose(), shifted, new Pose()), 1, 2);
    shifted.translation.set(4, 0, 0);
    either |=
        overlap(fragments, List.of(new Pose(), shifted, new Pose()), 1, 0)
            || overlap(fragments, List.of(new Pose(), shifted, new Pose()), 1, 2);
    assertTrue(either);
  }

  private static boolean overlap(Fragments fragments, List<Pose> poses, int one, int other) {
    VoxelGrid grid = fragments.grid();
    BitCube bits = fragments.bits().get(one);
    RigidTool tool = ToolSampler.ofSegment(bits, grid);
    Body body = new Body("other", fragments.bits().get(other), grid, Mobility.FIXED);
    body.setPose(poses.get(other));
    Vec3 reference = tool.referenceMm(new Vec3());
    Pose toolPose = new Pose();
    toolPose.set(poses.get(one).transform(reference, new Vec3()), poses.get(one).rotation);
    return new OverlapJudge(bits, grid, tool).overlaps(new BodyScene(List.of(body)), toolPose);
  }
}
