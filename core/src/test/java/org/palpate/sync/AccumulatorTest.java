package org.palpate.sync;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class AccumulatorTest {
  private static final long SEED = Long.getLong("palpate.seed", 20130613);

  private final Accumulator accumulator = new Accumulator();

  @Test
  void nothingIsDirtyBeforeTheFirstPublication() {
    NumberProperty number = accumulator.number("rate");
    number.set(3);
    assertFalse(accumulator.take());
    assertFalse(number.isDirty());
  }

  @Test
  void theLastValueWins() {
    NumberProperty number = accumulator.number("rate");
    for (int i = 1; i <= 5; i++) {
      number.set(i);
      accumulator.publish();
    }
    assertTrue(accumulator.take());
    assertEquals(5, number.read());
    assertEquals(new SyncCounters(5, 0, 5, 0), accumulator.counters());
  }

  @Test
  void anUnchangedValueIsNeitherWrittenNorPublished() {
    PositionProperty tip = accumulator.position("tip");
    tip.set(1, 2, 3);
    accumulator.publish();
    accumulator.take();
    tip.markApplied();
    tip.set(1, 2, 3);
    assertFalse(accumulator.isDirty());
    accumulator.publish();
    assertFalse(accumulator.take());
    assertEquals(new SyncCounters(1, 1, 1, 1), accumulator.counters());
  }

  @Test
  void onlyChangedPropertiesAreDirty() {
    PositionProperty tip = accumulator.position("tip");
    NumberProperty rate = accumulator.number("rate");
    tip.set(1, 2, 3);
    rate.set(1000);
    accumulator.publish();
    accumulator.take();
    tip.markApplied();
    rate.markApplied();
    tip.set(1, 2, 4);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertTrue(tip.isDirty());
    assertFalse(rate.isDirty());
    assertEquals(1000, rate.read());
  }

  @Test
  void aChangeOfAnEarlierPublicationStaysDirty() {
    PositionProperty tip = accumulator.position("tip");
    NumberProperty rate = accumulator.number("rate");
    tip.set(1, 2, 3);
    accumulator.publish();
    rate.set(1000);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertTrue(tip.isDirty());
    assertTrue(rate.isDirty());
  }

  @Test
  void aPropertyThatWasNotAppliedIsDirtyAtTheNextTake() {
    NumberProperty rate = accumulator.number("rate");
    rate.set(1000);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertTrue(accumulator.take());
    assertTrue(rate.isDirty());
    rate.markApplied();
    assertFalse(accumulator.take());
  }

  @Test
  void aTransformArrivesWhole() {
    TransformProperty pose = accumulator.transform("pose");
    RigidTransform turned =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(4, 5, 6));
    pose.set(turned);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertEquals(turned.toString(), pose.read().toString());
    pose.set(turned);
    accumulator.publish();
    accumulator.take();
    assertEquals(1, accumulator.counters().publications());
  }

  @Test
  void withoutSkippingAnUnchangedValueIsPublishedToo() {
    Accumulator everything = Accumulator.withoutSkipping();
    PositionProperty tip = everything.position("tip");
    for (int i = 0; i < 3; i++) {
      tip.set(1, 2, 3);
      everything.publish();
    }
    assertTrue(everything.take());
    assertEquals(new SyncCounters(3, 0, 3, 0), everything.counters());
  }

  @Test
  void noPropertyCanBeMadeAfterTheFirstPublication() {
    accumulator.number("rate").set(1);
    accumulator.publish();
    String message =
        assertThrows(IllegalStateException.class, () -> accumulator.number("late")).getMessage();
    assertEquals("a property must be made before the first publication: property=late", message);
  }

  @Test
  void aHandAtRestCausesNoPublication() {
    TouchProperties touch = new TouchProperties(accumulator);
    Vec3 d = new Vec3(1, 2, 3);
    for (int frame = 1; frame <= 10; frame++) {
      touch.publish(d, d, new Vec3(), true, frame);
    }
    accumulator.take();
    assertEquals(1, accumulator.counters().publications());
    assertEquals(1, touch.touch().frame());
  }

  /**
   * The naive reference keeps the values of the last publication. While a value is set and not yet
   * published, the reader keeps the values that it took before.
   */
  @Test
  void agreesWithANaiveReferenceOverRandomSetsPublicationsAndTakes() {
    int count = 130;
    NumberProperty[] numbers = new NumberProperty[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = accumulator.number("n" + i);
    }
    double[] set = new double[count];
    double[] published = new double[count];
    double[] expected = new double[count];
    double[] scene = new double[count];
    SplittableRandom random = new SplittableRandom(SEED);
    for (int step = 0; step < 200_000; step++) {
      int i = (int) ((random.nextLong() >>> 1) % count);
      int what = (int) ((random.nextLong() >>> 1) % 10);
      if (what < 7) {
        set[i] = (random.nextLong() >>> 1) % 4;
        numbers[i].set(set[i]);
      } else if (what < 9) {
        System.arraycopy(set, 0, published, 0, count);
        accumulator.publish();
      } else {
        apply(numbers, scene);
        if (!accumulator.isDirty()) {
          System.arraycopy(published, 0, expected, 0, count);
        }
        for (int n = 0; n < count; n++) {
          assertEquals(expected[n], scene[n], "seed=" + SEED + " step=" + step + " number=" + n);
        }
      }
    }
  }

  private void apply(NumberProperty[] numbers, double[] scene) {
    if (!accumulator.take()) {
      return;
    }
    for (int n = 0; n < numbers.length; n++) {
      if (numbers[n].isDirty()) {
        scene[n] = numbers[n].read();
        numbers[n].markApplied();
      }
    }
  }
}
