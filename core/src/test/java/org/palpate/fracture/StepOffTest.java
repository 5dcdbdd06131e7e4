package org.palpate.fracture;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.HollowShaft;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * Reads known step-offs of 0, 0.5, 1 and 2 mm, each in four directions, between all fragments that
 * touch. {@code -Dpalpate.fractures=N} reads N fractures of each kind, with and without a kerf.
 */
class StepOffTest {
  private static final int FRACTURES = Integer.getInteger("palpate.fractures", 1);

  private static final double[] OFFSETS_MM = {0, 0.5, 1, 2};
  private static final int DIRECTIONS = 4;

  /** Fragments whose faces are smaller do not count. */
  private static final double LEAST_FACE_MM2 = 40;

  private final List<Double> errorsMm = new ArrayList<>();

  @Test
  void theStepOffOfABrokenTubeIsReadExactly() {
    for (int seed = 1; seed <= FRACTURES; seed++) {
      for (int kerf = 0; kerf <= 1; kerf++) {
        FractureSpec spec = new FractureSpec(2, seed, kerf);
        read(FragmentCutter.cut(HollowShaft.bits(), HollowShaft.GRID, spec));
      }
    }
    check("tube", 0.05, 0.15);
  }

  @Test
  void theStepOffOfABentArchWithMarrowIsReadLessExactly() {
    for (int seed = 1; seed <= FRACTURES; seed++) {
      for (int kerf = 0; kerf <= 1; kerf++) {
        for (int parts = 4; parts <= 8; parts += 4) {
          String spec = "fracture:160:" + parts + ":" + seed + ":" + kerf;
          read(FracturePhantom.parse(spec).fragments());
        }
      }
    }
    check("arch", 0.2, 0.9);
  }

  private void check(String bone, double mostRmsMm, double mostMm) {
    double squares = 0;
    double largest = 0;
    for (double error : errorsMm) {
      squares += error * error;
      largest = Math.max(largest, Math.abs(error));
    }
    double rms = Math.sqrt(squares / errorsMm.size());
    String text =
        String.format(
            Locale.ROOT,
            "step-off of a broken %s: %d readings, rms error %.3f mm, largest %.3f mm",
            bone,
            errorsMm.size(),
            rms,
            largest);
    System.out.println(text);
    assertTrue(errorsMm.size() > 20 && rms <= mostRmsMm && largest <= mostMm, text);
  }

  private void read(Fragments fragments) {
    for (int one = 0; one < fragments.bits().size(); one++) {
      for (int other = 0; other < one; other++) {
        PairReadings atRest = read(fragments, one, other, new Pose());
        if (atRest.facingMm2() > LEAST_FACE_MM2) {
          read(fragments, one, other);
        }
      }
    }
  }

  private void read(Fragments fragments, int one, int other) {
    Vec3 across =
        new FacingFaces(at(fragments, one, new Pose()), at(fragments, other, new Pose()))
            .normalWorld();
    Vec3 beside = across.cross(new Vec3(0, 0, 1), new Vec3());
    if (beside.length() < 0.1) {
      across.cross(new Vec3(1, 0, 0), beside);
    }
    beside.mul(1 / beside.length(), beside);
    Vec3 above = across.cross(beside, new Vec3());
    for (double offset : OFFSETS_MM) {
      for (int n = 0; n < (offset == 0 ? 1 : DIRECTIONS); n++) {
        Pose pose = new Pose();
        (n % 2 == 0 ? beside : above).mul(n < 2 ? offset : -offset, pose.translation);
        double read = read(fragments, one, other, pose).stepOffMm();
        if (!Double.isNaN(read)) {
          errorsMm.add(read - offset);
        }
      }
    }
  }

  private static PairReadings read(Fragments fragments, int one, int other, Pose pose) {
    return PairReadings.read(at(fragments, one, pose), at(fragments, other, new Pose()));
  }

  private static PosedBits at(Fragments fragments, int fragment, Pose pose) {
    return new PosedBits(fragments.bits().get(fragment), fragments.grid(), pose);
  }
}
