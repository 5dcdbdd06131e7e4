package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** Compares votes with those of a look at every pair of poses. */
class PoseVotesTest {
  private static final long SEED = Long.getLong("palpate.seed", 20);
  private static final Vec3 CENTROID = new Vec3(7, -3, 2);

  @Test
  void aPoseHasTheVotesOfAllPosesNearIt() {
    SplittableRandom random = new SplittableRandom(SEED);
    List<FitCandidate> all = new ArrayList<>();
    for (int n = 0; n < 300; n++) {
      Pose pose = new Pose();
      pose.translation.set(between(random, 6), between(random, 6), between(random, 6));
      pose.rotation.setRotationVector(
          new Vec3(between(random, 0.15), between(random, 0.15), between(random, 0.15)));
      all.add(new FitCandidate(pose, random.nextDouble()));
    }
    int voters = 0;
    List<FitCandidate> voted = PoseVotes.count(all, CENTROID, 1);
    assertEquals(all.size(), voted.size());
    for (FitCandidate each : voted) {
      double votes = 0;
      for (FitCandidate other : all) {
        if (FitCandidate.isNear(each.pose(), other.pose(), CENTROID, 5, Math.toRadians(12))) {
          votes += other.score();
          voters++;
        }
      }
      assertEquals(votes, each.score(), 1e-9, "seed " + SEED);
    }
    assertTrue(voters > 2 * all.size() && voters < all.size() * all.size() / 2, "" + voters);
  }

  private static double between(SplittableRandom random, double limit) {
    return (2 * random.nextDouble() - 1) * limit;
  }
}
