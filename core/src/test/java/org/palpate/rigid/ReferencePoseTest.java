package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class ReferencePoseTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aConversionThereAndBackGivesTheSameBits() {
    for (int n = 0; n < 100_000; n++) {
      double size = Math.pow(10, random.nextDouble(-3, 5.5));
      ReferencePose reference = new ReferencePose(RandomGeometry.vector(random, size));
      Pose rest = ReferencePose.snap(RandomGeometry.pose(random, size));
      Pose there = reference.toReference(rest, new Pose());
      assertTrue(reference.toRest(there, new Pose()).sameBits(rest));
      Pose snapped = ReferencePose.snap(new Pose().set(there));
      assertTrue(snapped.sameBits(there), "the other form lies on the lattice too");
    }
  }

  @Test
  void theReferencePointLiesWhereThePoseTakesIt() {
    for (int n = 0; n < 10_000; n++) {
      Vec3 point = RandomGeometry.vector(random, 500);
      Pose rest = ReferencePose.snap(RandomGeometry.pose(random, 500));
      Pose there = new ReferencePose(point).toReference(rest, new Pose());
      Vec3 expected = rest.transform(point, new Vec3());
      assertTrue(there.translation.sub(expected, expected).length() < 1e-9);
    }
  }

  @Test
  void aSnappedPoseIsWithinTheLimitsAndHasNoNegativeZero() {
    Pose pose = new Pose();
    pose.translation.set(-0.0, 1e12, -1e-12);
    ReferencePose.snap(pose);
    assertEquals("0.0", Double.toString(pose.translation.x));
    assertEquals(ReferencePose.LARGEST_MM, pose.translation.y);
    assertEquals("0.0", Double.toString(pose.translation.z));
  }
}
