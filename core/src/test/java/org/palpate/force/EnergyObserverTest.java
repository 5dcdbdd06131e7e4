package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

class EnergyObserverTest {
  private final EnergyObserver observer = new EnergyObserver();

  @Test
  void aBodyThatGainsNoMoreThanTheHandGaveKeepsItsSpeed() {
    observer.begin(10);
    assertEquals(1, observer.account(4, 12, 2));
    assertEquals(1, observer.account(4, 11, 0), "and one that loses energy");
    assertEquals(0, observer.debt());
    assertEquals(0, observer.taken());
  }

  @Test
  void aSurplusIsTakenFromTheMotion() {
    observer.begin(10);
    double factor = observer.account(4, 15, 2);
    assertEquals(Math.sqrt(1 / 4.0), factor, 1e-15, "3 mJ of 4 are gone");
    assertEquals(0, observer.debt());
    assertEquals(3, observer.taken());
    assertEquals(1, observer.account(1, 12, 0), "the body has 12 mJ from now on");
    assertEquals(0.5, observer.account(4, 15, 0), 1e-15);
    assertEquals(6, observer.taken());
  }

  @Test
  void whatTheMotionCannotPayIsADebtThatLaterFramesPay() {
    observer.begin(0);
    assertEquals(0, observer.account(2, 5, 0), "all motion is taken");
    assertEquals(3, observer.debt());
    assertEquals(1, observer.account(0, 3, 0), "without motion there is nothing to take");
    assertEquals(3, observer.debt());
    assertEquals(Math.sqrt(1 / 4.0), observer.account(4, 7, 4), 1e-15);
    assertEquals(0, observer.debt());
    assertEquals(5, observer.taken());
  }

  @Test
  void aLossPaysADebtButIsNoCreditForLater() {
    observer.begin(0);
    observer.account(0, 5, 0);
    assertEquals(5, observer.debt());
    assertEquals(1, observer.account(0, 3, 0));
    assertEquals(3, observer.debt(), "2 mJ were lost");
    assertEquals(1, observer.account(9, 0, 9));
    assertEquals(0, observer.debt(), "more was lost than was owed");
    assertEquals(0, observer.account(2, 2, 0), "which pays for nothing later");
    assertEquals(2, observer.taken());
  }

  @Test
  void aNewBeginForgetsTheDebtButNotWhatWasTaken() {
    observer.begin(0);
    observer.account(1, 5, 0);
    observer.begin(7);
    assertEquals(0, observer.debt());
    assertEquals(1, observer.taken());
    assertEquals(1, observer.account(3, 7, 0));
  }

  /** In each frame the energy less the debt grows by the work of the hand and no more. */
  @Test
  void theEnergyLessTheDebtNeverGrowsByMoreThanTheWorkOfTheHand() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    double stored = 5;
    int paid = 0;
    int owed = 0;
    observer.begin(stored);
    for (int frame = 0; frame < 20_000; frame++) {
      double before = stored - observer.debt();
      double work = random.nextDouble(-1, 1);
      double energy = Math.max(0, stored + random.nextDouble(-1.1, 1.2));
      double kinetic = energy * random.nextDouble();
      double factor = observer.account(kinetic, energy, work);
      stored = energy - kinetic * (1 - factor * factor);
      assertTrue(stored - observer.debt() <= before + work + 1e-9, "frame " + frame);
      assertTrue(factor >= 0 && factor <= 1 && observer.debt() >= 0, "frame " + frame);
      paid += factor < 1 ? 1 : 0;
      owed += observer.debt() > 0 ? 1 : 0;
    }
    assertTrue(paid > 3_000 && owed > 100, "frames that paid: " + paid + ", owed: " + owed);
  }
}
