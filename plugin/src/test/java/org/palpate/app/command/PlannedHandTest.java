package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HandStop;
import org.palpate.device.ReadStatus;
import org.palpate.device.Tremor;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** A hand whose plan another thread makes is that hand once the plan is there. */
class PlannedHandTest {
  private static final long MS = 1_000_000;
  private static final double RADIUS_MM = 80;

  private final DeviceState state = new DeviceState();
  private final CountDownLatch mayPlan = new CountDownLatch(1);

  private static GuidedHand guided() {
    List<HandStop> stops =
        List.of(
            new HandStop(Pose.at(0, 0, 0), 0, 0, false),
            new HandStop(Pose.at(60, 0, 0), 1, 1, true));
    return new GuidedHand(stops, Tremor.ofHand(3), RADIUS_MM, MS);
  }

  private PlannedHand planned(Supplier<GuidedHand> plan) {
    return new PlannedHand(
        RADIUS_MM,
        () -> {
          awaitPermission();
          return plan.get();
        });
  }

  private void awaitPermission() {
    try {
      mayPlan.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private void awaitReady(PlannedHand hand) {
    mayPlan.countDown();
    while (!hand.isReady()) {
      Thread.onSpinWait();
    }
  }

  @Test
  void isNotReadyAndDeliversNothingBeforeThePlanIsMade() {
    PlannedHand hand = planned(PlannedHandTest::guided);
    assertFalse(hand.isReady());
    assertEquals(ReadStatus.REPEATED, hand.read(state));
    assertTrue(hand.write(new Vec3(), new Vec3()));
    awaitReady(hand);
    assertEquals(ReadStatus.FRESH, hand.read(state));
  }

  @Test
  void isTheHandOfThePlanOnceItIsReady() {
    PlannedHand hand = planned(PlannedHandTest::guided);
    GuidedHand same = guided();
    assertEquals(same.specification(), hand.specification());
    awaitReady(hand);
    DeviceState expected = new DeviceState();
    for (int n = 0; n < 1500; n++) {
      assertEquals(same.read(expected), hand.read(state));
      assertTrue(expected.positionMm.sameBits(state.positionMm), "sample " + n);
      assertTrue(expected.orientation.sameBits(state.orientation), "sample " + n);
      assertEquals(expected.buttons, state.buttons);
      assertEquals(expected.timeNanos, state.timeNanos);
    }
  }

  @Test
  void aPlanThatFailsIsReportedWithItsCause() {
    ArithmeticException fault = new ArithmeticException("no way");
    PlannedHand hand =
        planned(
            () -> {
              throw fault;
            });
    IllegalStateException failure =
        assertThrows(IllegalStateException.class, () -> awaitReady(hand));
    assertSame(fault, failure.getCause());
  }

  @Test
  void anErrorOfTheJvmStaysWhatItIs() {
    OutOfMemoryError fault = new OutOfMemoryError("Java heap space");
    PlannedHand hand =
        planned(
            () -> {
              throw fault;
            });
    assertSame(fault, assertThrows(OutOfMemoryError.class, () -> awaitReady(hand)));
  }

  @Test
  void aClosedHandIsGoneBeforeAndAfterItsPlan() {
    PlannedHand unplanned = planned(PlannedHandTest::guided);
    PlannedHand planned = planned(PlannedHandTest::guided);
    awaitReady(planned);
    for (PlannedHand hand : List.of(unplanned, planned)) {
      hand.close();
      assertTrue(hand.isReady(), "nobody waits for a closed hand");
      assertEquals(ReadStatus.DISCONNECTED, hand.read(state));
      assertFalse(hand.write(new Vec3(), new Vec3()));
    }
  }

  @Test
  void closingEndsThePlan() throws InterruptedException {
    CountDownLatch interrupted = new CountDownLatch(1);
    PlannedHand hand =
        new PlannedHand(
            RADIUS_MM,
            () -> {
              try {
                return cancelled();
              } finally {
                interrupted.countDown();
              }
            });
    hand.close();
    assertTrue(interrupted.await(30, TimeUnit.SECONDS), "the plan goes on");
  }

  @Test
  void closingWhileTheLoopLooksForThePlanIsNoFailure() throws InterruptedException {
    for (int n = 0; n < 2000; n++) {
      PlannedHand hand = new PlannedHand(RADIUS_MM, PlannedHandTest::cancelled);
      Thread closer = new Thread(hand::close);
      closer.start();
      while (!hand.isReady()) {
        hand.read(state);
      }
      closer.join();
      assertEquals(ReadStatus.DISCONNECTED, hand.read(state));
    }
  }

  private static GuidedHand cancelled() {
    while (!Thread.interrupted()) {
      Thread.onSpinWait();
    }
    throw new CancellationException();
  }
}
