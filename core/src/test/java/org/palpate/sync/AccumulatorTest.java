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
    assertEquals(new SyncCounters(5, 0, 5, 0), accumulator.counts());
  }

  @Test
  void anUnchangedValueIsNeitherWrittenNorPublished() {
    PositionProperty tip = accumulator.position("tip");
    tip.set(1, 2, 3);
    accumulator.publish();
    accumulator.take();
    tip.applied();
    tip.set(1, 2, 3);
    assertFalse(accumulator.isDirty());
    accumulator.publish();
    assertFalse(accumulator.take());
    assertEquals(new SyncCounters(1, 1, 1, 1), accumulator.counts());
  }

  @Test
  void onlyWhatChangedIsDirty() {
    PositionProperty tip = accumulator.position("tip");
    ColourProperty colour = accumulator.colour("bone");
    tip.set(1, 2, 3);
    colour.set(0xFF102030);
    accumulator.publish();
    accumulator.take();
    tip.applied();
    colour.applied();
    tip.set(1, 2, 4);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertTrue(tip.isDirty());
    assertFalse(colour.isDirty());
    assertEquals(0xFF102030, colour.read());
  }

  @Test
  void aChangeThatTheReaderSkippedOverStaysDirty() {
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
  void aPropertyThatWasNotAppliedIsDirtyAtTheNextTick() {
    VisibilityProperty shown = accumulator.visibility("force arrow");
    shown.set(true);
    accumulator.publish();
    assertTrue(accumulator.take());
    assertTrue(accumulator.take());
    assertTrue(shown.isDirty());
    shown.applied();
    assertFalse(accumulator.take());
  }

  @Test
  void everyKindOfPropertyArrivesWhole() {
    TransformProperty pose = accumulator.transform("pose");
    LinesProperty trail = accumulator.lines("trail", 3);
    TextProperty text = accumulator.text("overlay", 9);
    RigidTransform turned =
        new RigidTransform(
            new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(4, 5, 6));
    pose.set(turned);
    trail.begin().add(1, 2, 3).add(4, 5, 6).add(7, 8, 9).add(10, 11, 12).end();
    text.set("guarded \u00b5m");
    accumulator.publish();
    assertTrue(accumulator.take());
    assertEquals(turned.toString(), pose.read().toString());
    assertEquals(3, trail.count());
    assertEquals("(7.0, 8.0, 9.0)", trail.read(2, new Vec3()).toString());
    assertEquals("guarded \u00b5", text.read());
  }

  @Test
  void aShorterTextOrLineIsAChange() {
    LinesProperty trail = accumulator.lines("trail", 3);
    TextProperty text = accumulator.text("overlay", 9);
    trail.begin().add(1, 2, 3).add(4, 5, 6).end();
    text.set("contact");
    accumulator.publish();
    trail.begin().add(1, 2, 3).end();
    text.set("cont");
    accumulator.publish();
    accumulator.take();
    assertEquals(1, trail.count());
    assertEquals("cont", text.read());
  }

  @Test
  void propertiesAreMadeBeforeTheFirstPublication() {
    accumulator.number("rate").set(1);
    accumulator.publish();
    String message =
        assertThrows(IllegalStateException.class, () -> accumulator.number("late")).getMessage();
    assertEquals("properties are made before the first publication: property=late", message);
  }

  @Test
  void aRestingHandCausesNoPublication() {
    TouchProperties touch = new TouchProperties(accumulator);
    Vec3 d = new Vec3(1, 2, 3);
    for (int frame = 1; frame <= 10; frame++) {
      touch.publish(d, d, new Vec3(), true, frame);
    }
    accumulator.take();
    assertEquals(1, accumulator.counts().publications());
    assertEquals(1, touch.touch().frame());
  }

  /**
   * The naive twin: what was last published, property by property; while something is set and not
   * yet published, what was taken before.
   */
  @Test
  void agreesWithANaiveTwinOverRandomSetsPublicationsAndTakes() {
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
        numbers[n].applied();
      }
    }
  }
}
