package org.palpate.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class GuidedHandTest {
  private static final long MS = 1_000_000;
  private static final Quaternion TURNED = new Quaternion().setRotationVector(new Vec3(0, 0, 0.5));

  private static final HandStop FIRST = new HandStop(new Pose(), 0, 0.1, false);
  private static final HandStop SECOND =
      new HandStop(new Pose().set(new Vec3(60, 0, 0), TURNED), 1, 1, true);

  private final DeviceState state = new DeviceState();

  @Test
  void goesFromStopToStopAtItsMeanSpeedAndPressesTheButtonOnArrival() {
    GuidedHand hand = hand(Tremor.NONE);
    assertEquals(1.1, hand.durationSeconds(), 1e-12);
    read(hand, 101);
    assertTrue(state.positionMm.sameBits(new Vec3()), "rests first");
    read(hand, 500);
    assertEquals(30, state.positionMm.x, 1e-9, "is half way after half a second");
    assertEquals(0, state.buttons);
    read(hand, 501);
    assertTrue(state.positionMm.sameBits(new Vec3(60, 0, 0)));
    assertTrue(state.orientation.sameBits(TURNED));
    assertEquals(1, state.buttons);
    read(hand, 5000);
    assertEquals(60, state.positionMm.x, "stays at the last stop");
  }

  @Test
  void aSlowRotationSetsTheDurationIfItTakesLonger() {
    HandStop far =
        new HandStop(
            new Pose().set(new Vec3(), new Quaternion().setRotationVector(new Vec3(0, 2, 0))),
            0,
            0,
            false);
    assertEquals(
        2.1, new GuidedHand(List.of(FIRST, far), Tremor.NONE, 100, MS).durationSeconds(), 1e-12);
  }

  @Test
  void theTremorShakesAtItsFrequencyAndDiesAwayAtASteadyStop() {
    GuidedHand hand = hand(new Tremor(0.3, 0.02, 8, 5));
    double most = 0;
    int crossings = 0;
    double last = 0;
    for (int n = 0; n < 100; n++) {
      read(hand, 1);
      most = Math.max(most, Math.abs(state.positionMm.y));
      crossings += state.positionMm.y * last < 0 ? 1 : 0;
      last = state.positionMm.y;
    }
    assertEquals(0.3, most, 0.05);
    assertTrue(crossings == 1 || crossings == 2, "0.8 of a period crosses zero: " + crossings);
    read(hand, 1400);
    assertTrue(state.positionMm.sameBits(new Vec3(60, 0, 0)), "steady: " + state.positionMm);
  }

  private static List<HandStop> threeStops() {
    HandStop third = new HandStop(Pose.at(60, 40, 0), 0, 0.5, false);
    return List.of(FIRST, new HandStop(Pose.at(60, 0, 0), 0, 0, false), third);
  }

  /** Reads a hand that skipped its first samples beside one that did not. */
  private void assertMovesAs(GuidedHand begins, GuidedHand came, int skipped) {
    read(came, skipped);
    DeviceState other = new DeviceState();
    for (int n = 0; n < 1500; n++) {
      begins.read(other);
      assertEquals(n * MS, other.timeNanos, "its clock begins with its first sample");
      read(came, 1);
      assertTrue(state.positionMm.sameBits(other.positionMm), "sample " + n);
      assertTrue(state.orientation.sameBits(other.orientation), "sample " + n);
    }
    assertEquals(60, other.positionMm.x, 0.5);
    assertEquals(40, other.positionMm.y, 0.5);
  }

  private static GuidedHand trembling() {
    return new GuidedHand(threeStops(), Tremor.ofHand(4), 100, MS);
  }

  @Test
  void aHandThatBeginsAtAStopMovesAndTremblesAsOneThatCameThere() {
    GuidedHand begins = trembling();
    begins.beginAfter(1, 1000);
    assertMovesAs(begins, trembling(), 1101); // a rest of 0.1 s, then 60 mm
  }

  @Test
  void aHandThatBeginsOnTheWayMovesAndTremblesAsOneThatCameThere() {
    GuidedHand begins = trembling();
    begins.beginAfter(1, 10);
    GuidedHand came = trembling();
    int skipped = 0;
    do {
      read(came, 1);
      skipped++;
    } while (state.positionMm.sub(new Vec3(60, 40, 0), new Vec3()).length() > 10);
    assertTrue(
        skipped > 1400 && skipped < 1700, "between the second stop and the third: " + skipped);
    assertMovesAs(begins, trembling(), skipped);
  }

  @Test
  void aHandThatBeginsAtItsFirstStopIsUnchanged() {
    GuidedHand hand = hand(Tremor.NONE);
    hand.beginAfter(0, 60.1);
    read(hand, 600);
    assertEquals(30, state.positionMm.x, 0.2, "is half way after the rest and half a second");
  }

  @Test
  void aHandThatIsClosedDoesNotBegin() {
    GuidedHand hand = trembling();
    hand.close();
    assertTimeoutPreemptively(Duration.ofSeconds(30), () -> hand.beginAfter(1, 10));
    assertEquals(ReadStatus.DISCONNECTED, hand.read(state));
  }

  @Test
  void correctsByEyeWhatItHolds() {
    Pose goal = new Pose().set(new Vec3(3, 2, 1), TURNED);
    Pose grip = new Pose().set(new Vec3(0, 5, 0), new Quaternion());
    Pose seen = new Pose();
    HandStop aimed =
        new HandStop(
            new Pose(), 1, 10, true, Optional.of(new HandStop.Aim(() -> seen, goal, 0, 0, 1)), 1);
    GuidedHand hand = new GuidedHand(List.of(aimed), Tremor.NONE, 100, MS);
    for (int n = 0; n < 5000; n++) {
      hand.read(state);
      new Pose().set(state.positionMm, state.orientation).multiply(grip, seen);
    }
    assertEquals(0, seen.translation.sub(goal.translation, new Vec3()).length(), 1e-6);
    assertEquals(1, Math.abs(seen.rotation.dot(goal.rotation)), 1e-9);
  }

  @Test
  void comesAgainWhileAThingIsNotAtItsGoalAndThenGoesAnotherWay() {
    List<Double> visited = visits(new Pose().set(new Vec3(9, 0, 0), new Quaternion()));
    assertEquals(List.of(0.0, 6.0, 0.0, 6.0, 0.0, -6.0), visited);
  }

  @Test
  void goesOnWhenAThingIsAtItsGoal() {
    assertEquals(List.of(0.0, 6.0, 3.0, -6.0), visits(new Pose()));
  }

  /** Returns where a hand rests that tries twice to bring a thing home that stays where it is. */
  private List<Double> visits(Pose seen) {
    HandStop.Aim aim = new HandStop.Aim(() -> seen, new Pose(), 2, 1, 2);
    List<HandStop> stops =
        List.of(
            new HandStop(at(0), 1, 0.1, false),
            new HandStop(at(6), 1, 0.2, false, Optional.of(aim), 1),
            new HandStop(at(3), 1, 0.1, false),
            new HandStop(at(-6), 0, 0.1, false));
    return visits(stops);
  }

  /** Returns where a hand rests. */
  private List<Double> visits(List<HandStop> stops) {
    GuidedHand hand = new GuidedHand(stops, Tremor.NONE, 100, MS);
    List<Double> visited = new ArrayList<>();
    double last = Double.NaN;
    int still = 0;
    for (int n = 0; !hand.hasArrived(); n++) {
      assertTrue(n < 5000, "the hand arrives");
      hand.read(state);
      still = Math.abs(state.positionMm.x - last) < 0.05 ? still + 1 : 0;
      last = state.positionMm.x;
      assertTrue(last < 6.51 && last > -6.51, "leads at most by half a mm: " + last);
      if (still == 50) {
        visited.add((double) Math.round(last));
      }
    }
    return visited;
  }

  @Test
  void goesBackFartherEachTimeAndAllTheWayBeforeItGivesUp() {
    Pose away = new Pose().set(new Vec3(9, 0, 0), new Quaternion());
    HandStop.Aim aim = new HandStop.Aim(() -> away, new Pose(), 4, 2, 1);
    List<HandStop> stops =
        List.of(
            new HandStop(at(0), 1, 0.1, false),
            new HandStop(at(4), 1, 0.1, false),
            new HandStop(at(6), 1, 0.2, false, Optional.of(aim), 1),
            new HandStop(at(-6), 0, 0.1, false));
    List<Double> expected =
        List.of(0.0, 4.0, 6.0, 4.0, 6.0, 4.0, 0.0, 4.0, 6.0, 4.0, 6.0, 4.0, 0.0, -6.0);
    assertEquals(expected, visits(stops));
  }

  @Test
  void eachOfTwoWaysHasItsOwnTries() {
    Pose away = new Pose().set(new Vec3(9, 0, 0), new Quaternion());
    HandStop.Aim aim = new HandStop.Aim(() -> away, new Pose(), 2, 1, 1);
    List<HandStop> stops =
        List.of(
            new HandStop(at(0), 1, 0.1, false),
            new HandStop(at(6), 1, 0.2, false, Optional.of(aim), 1),
            new HandStop(at(3), 1, 0.1, false),
            new HandStop(at(5), 1, 0.2, false, Optional.of(aim), 1),
            new HandStop(at(-6), 0, 0.1, false));
    List<Double> expected = List.of(0.0, 6.0, 0.0, 6.0, 0.0, 3.0, 5.0, 3.0, 5.0, 3.0, -6.0);
    assertEquals(expected, visits(stops));
  }

  @Test
  void anAimWithTriesNeedsAStopToGoBackTo() {
    IllegalArgumentException refusal =
        assertThrows(
            IllegalArgumentException.class, () -> new HandStop.Aim(Pose::new, new Pose(), 3, 0, 1));
    assertTrue(refusal.getMessage().endsWith("tries=3, back=0"), refusal.getMessage());
  }

  /** A hand that comes back to a steady stop at once is nearly as steady as it was. */
  @Test
  void theTremorNeverJumps() {
    List<HandStop> stops = new ArrayList<>();
    for (int n = 0; n < 6; n++) {
      stops.add(new HandStop(at(n % 2), 1, n % 2 == 0 ? 0.4 : 0, n % 2 == 0));
    }
    GuidedHand hand = new GuidedHand(stops, new Tremor(0.3, 0.02, 8, 5), 100, MS);
    double fastest = 0;
    double last = Double.NaN;
    while (!hand.hasArrived()) {
      hand.read(state);
      fastest = Double.isNaN(last) ? 0 : Math.max(fastest, Math.abs(state.positionMm.y - last));
      last = state.positionMm.y;
    }
    double mostAMillisecond = 0.3 * (2 * Math.PI * 8 + 1 / 0.3) / 1000;
    assertTrue(fastest > 0 && fastest <= mostAMillisecond, "mm in a millisecond: " + fastest);
  }

  private static Pose at(double x) {
    return new Pose().set(new Vec3(x, 0, 0), new Quaternion());
  }

  /** Each look corrects by a fraction, so that the rest falls to 1/e within 200 ms. */
  @ParameterizedTest
  @ValueSource(ints = {1000, 5000, 10_000})
  void correctsAsFastAtEveryRate(int hertz) {
    Pose goal = new Pose().set(new Vec3(3, 0, 0), new Quaternion());
    Pose seen = new Pose();
    HandStop aimed =
        new HandStop(
            new Pose(), 9, 10, true, Optional.of(new HandStop.Aim(() -> seen, goal, 0, 0, 1)), 1);
    GuidedHand hand = new GuidedHand(List.of(aimed), Tremor.NONE, 100, 1000 * MS / hertz);
    for (int n = 0; n < hertz / 5; n++) {
      hand.read(state);
      seen.set(state.positionMm, state.orientation);
    }
    assertEquals(3 * (1 - Math.exp(-1)), seen.translation.x, 0.02);
  }

  @Test
  void theSameStopsAndSeedGiveTheSameBits() {
    GuidedHand one = hand(new Tremor(0.3, 0.02, 8, 5));
    GuidedHand other = hand(new Tremor(0.3, 0.02, 8, 5));
    DeviceState second = new DeviceState();
    for (int n = 0; n < 1500; n++) {
      one.read(state);
      other.read(second);
      assertTrue(state.positionMm.sameBits(second.positionMm), "sample " + n);
      assertTrue(state.orientation.sameBits(second.orientation), "sample " + n);
    }
  }

  private static GuidedHand hand(Tremor tremor) {
    return new GuidedHand(List.of(FIRST, SECOND), tremor, 100, MS);
  }

  private void read(GuidedHand hand, int samples) {
    for (int n = 0; n < samples; n++) {
      hand.read(state);
    }
  }
}
