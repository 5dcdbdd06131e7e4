package org.palpate.rigid.skip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ScreenTrialTest {
  private static final int LEAVES = 50;
  private static final int POINTS = 24;

  private final ScreenTrial trial = new ScreenTrial();

  @Test
  void aScreenThatSavesTestsIsAskedInNearlyAllVerifications() {
    int asked = 0;
    for (int n = 0; n < 20_000; n++) {
      asked += verify(1, LEAVES, LEAVES) ? 1 : 0;
    }
    // Trials come after 64, 128, 256 ... verifications, and each ends within its first one.
    assertTrue(asked >= 20_000 - 12, asked + " asked");
  }

  @Test
  void aScreenThatSavesNothingIsLeftOutAfterOneTrial() {
    for (int n = 0; n < 64; n++) {
      assertTrue(verify(LEAVES, LEAVES, LEAVES));
    }
    for (int n = 0; n < 10_000; n++) {
      assertFalse(verify(LEAVES, LEAVES, LEAVES), "verification " + n);
    }
  }

  @Test
  void testsThatFreePointsForLaterCountInTheEndOnly() {
    for (int n = 0; n < 64; n++) {
      verify(20, LEAVES, LEAVES);
    }
    for (int n = 0; n < 100; n++) { // the first verification of the trial frees most leaves
      assertFalse(verify(20, LEAVES, n == 0 ? LEAVES : 5), "verification " + n);
    }
  }

  @Test
  void aTrialThatCostsMoreEndsAndTheNextComesLater() {
    int[] lengths = new int[3];
    for (int period = 0; period < lengths.length; period++) {
      while (verify(20, LEAVES, LEAVES)) {
        lengths[period]++;
      }
      for (int n = 1; n < 8; n++) { // each costs more than asking, but less than four times that
        assertFalse(verify(20, LEAVES, LEAVES));
      }
    }
    assertEquals(64, lengths[0]);
    assertEquals(128, lengths[1]);
    assertEquals(256, lengths[2]);
  }

  @Test
  void aVerificationThatBecomesTooDearAsksAtOnce() {
    aScreenThatSavesNothingIsLeftOutAfterOneTrial();
    trial.begin();
    int left = 0;
    while (!asks()) {
      left++;
    }
    trial.end();
    // Asking cost the answers and all points of 50 leaves. Four times that is left out at most.
    assertTrue(left > 0 && left <= 4 * LEAVES * (4 + POINTS) / POINTS, left + " leaves");
    assertTrue(verify(LEAVES, LEAVES, LEAVES), "it goes on asking");
  }

  private boolean asks() {
    trial.comeTo(POINTS);
    return trial.asks();
  }

  /**
   * Runs a verification.
   *
   * @param notFound the leaves that the screen does not find, if it is asked
   * @param leaves the leaves for which it may be asked
   * @param without those that are left if it is not asked
   * @return whether it was asked for the last leaf
   */
  private boolean verify(int notFound, int leaves, int without) {
    trial.begin();
    boolean asked = asks();
    int count = asked ? leaves : without;
    for (int n = 1; n <= count; n++) {
      if (asked) {
        trial.countAnswer();
        trial.countPoints(n <= notFound ? POINTS : 0);
      }
      asked = n < count ? asks() : asked;
    }
    trial.end();
    return asked;
  }
}
