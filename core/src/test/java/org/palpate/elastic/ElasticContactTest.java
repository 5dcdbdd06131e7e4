package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

class ElasticContactTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private static ElasticTouch above(double young, double k, double edge, boolean smooth) {
    ElasticTouch touch = new ElasticTouch(ElasticTouch.Scene.block(UNIT), young, k, edge, smooth);
    touch.hand.set(48.3, 48.4, 52);
    for (int n = 0; n < 80; n++) {
      touch.run();
    }
    return touch;
  }

  @ParameterizedTest
  @CsvSource({"false", "true"})
  void giveWayUnderTheHandAndComeBack(boolean smooth) {
    ElasticTouch touch = above(20e3, 0.5, 8, smooth);
    touch.moveTo(48.3, 48.4, 44, 400);
    touch.moveTo(48.3, 48.4, 44, 400);
    double pressed = touch.frame.presentPosition().z;
    double newton = touch.frame.forceNewton().z;
    // The spring alone would give k times 4 mm; the material takes a part of the way.
    assertTrue(newton > 0.3 && newton < 1.8, "force " + newton);
    assertTrue(pressed > 44.2 && pressed < 47.7, "surface at " + pressed);
    double height = touch.frame.point().surfaceHeightMm;
    assertEquals(newton, 0.5 * (pressed - 44 - height), 1e-3);
    touch.moveTo(48.3, 48.4, 52, 400);
    touch.moveTo(48.3, 48.4, 52, 400);
    assertEquals(0, touch.frame.forceNewton().length(), 1e-9);
    Vec3 hand = touch.frame.presentPosition().sub(touch.hand, new Vec3());
    assertEquals(0, hand.length(), 1e-6, "off the hand");
  }

  /** Before the point moves, the force is that of the field in use, also in its first frame. */
  @Test
  void eachFrameBeginsWithTheForceAtWhichTheSpringAndTheFieldBalance() {
    ElasticTouch touch = above(20e3, 0.5, 8, false);
    touch.moveTo(48.3, 48.4, 44, 200);
    DeformationMap map = touch.body.contact().map();
    Vec3 force = new Vec3();
    Vec3 stretch = new Vec3();
    int newFields = 0;
    for (int n = 0; n < 300; n++) {
      touch.hand.x += 0.03;
      touch.updates.beforeFrame();
      DeformationField before = map.field();
      Vec3 target = touch.body.contact().begin(touch.hand, touch.frame.point(), 0.5);
      newFields += map.field() == before ? 0 : 1;
      Vec3 point = touch.frame.point().position;
      map.forward(target, stretch).sub(map.forward(point, force), stretch);
      map.force(force);
      assertEquals(0, touch.frame.point().surfaceHeightMm);
      assertEquals(0, force.sub(stretch.mul(0.5, stretch), force).length(), 1e-9, "frame " + n);
      touch.runWithoutUpdate();
    }
    assertTrue(newFields >= 8, "fields " + newFields);
  }

  @Test
  void aShapeThatNothingPressesIsAtRestAfterOneUpdate() {
    ElasticTouch touch = above(20e3, 0.5, 8, false);
    touch.moveTo(48.3, 48.4, 44, 200);
    assertTrue(largestDisplacement(touch) > 0.1);
    touch.hand.set(48.3, 48.4, 60);
    for (int n = 0; n < 5; n++) {
      touch.runWithoutUpdate();
    }
    touch.body.updater().compute(touch.body.contact().load());
    touch.runWithoutUpdate();
    assertEquals(0, largestDisplacement(touch));
  }

  private static double largestDisplacement(ElasticTouch touch) {
    double largest = 0;
    for (int node = 0; node < touch.lattice.layout().nodeCount(); node++) {
      for (int axis = 0; axis < 3; axis++) {
        double displacement = touch.body.contact().map().displacement(node, axis);
        largest = Math.max(largest, Math.abs(displacement));
      }
    }
    return largest;
  }

  @Test
  void theFirstPressBeforeAnUpdateIsNotClipped() {
    ElasticTouch touch = above(100e3, 1, 8, false);
    touch.moveTo(48.3, 48.4, 48.1, 40);
    for (int n = 1; n <= 40; n++) {
      touch.hand.set(48.3, 48.4, 48.1 - 0.1 * n);
      touch.runWithoutUpdate();
    }
    assertTrue(touch.frame.forceNewton().z > 2, "force " + touch.frame.forceNewton().z);
    assertEquals(0, touch.body.contact().clippedFrames());
  }

  @Test
  void aStiffSegmentFeelsLikeARigidOne() {
    ElasticTouch touch = above(1e9, 0.5, 8, false);
    touch.moveTo(48.3, 48.4, 44, 400);
    touch.moveTo(48.3, 48.4, 44, 200);
    assertEquals(0.5 * 4, touch.frame.forceNewton().z, 0.01);
  }

  /** The largest change of the force at an update beyond stiffness times motion, N. */
  private static double largestStep(ElasticTouch touch, int frames, double dx, double dz) {
    double largest = 0;
    Vec3 last = new Vec3();
    Vec3 difference = new Vec3();
    for (int n = 0; n < frames; n++) {
      last.set(touch.frame.forceNewton());
      touch.hand.set(touch.hand.x + dx, touch.hand.y, touch.hand.z + dz);
      touch.run();
      touch.frame.forceNewton().sub(last, difference);
      double motion = touch.newtonPerMm * Math.hypot(dx, dz);
      largest = Math.max(largest, difference.length() - motion);
    }
    return largest;
  }

  @Test
  void updatesMakeNoStepOfTheForceWhilePressing() {
    ElasticTouch touch = above(20e3, 0.5, 8, false);
    touch.moveTo(48.3, 48.4, 48.2, 60);
    double step = largestStep(touch, 700, 0, -0.01);
    step = Math.max(step, largestStep(touch, 300, 0, 0));
    System.out.printf("step while pressing: %.5f N%n", step);
    assertTrue(step < 0.02, "step " + step);
  }

  /** A dimple that lagged behind the hand would be a slope before it. */
  @Test
  void aSlideAcrossAFlatFaceHoldsTheHandBackLittle() {
    ElasticTouch touch = above(20e3, 0.5, 8, false);
    touch.moveTo(38.3, 48.4, 50, 50);
    touch.moveTo(38.3, 48.4, 38, 600);
    double back = 0;
    double up = 0;
    for (int n = 0; n < 350; n++) {
      touch.hand.x += 0.06;
      touch.run();
      back -= touch.frame.forceNewton().x;
      up += touch.frame.forceNewton().z;
    }
    System.out.printf("slide at 60 mm/s: holds back by %.4f of the force%n", back / up);
    assertTrue(back / up < 0.04, "holds back by " + back / up);
  }

  /** Slides along x and returns the mean force on the hand. */
  private static Vec3 slidingForce(ForceSettings force) {
    ElasticTouch touch = new ElasticTouch(ElasticTouch.Scene.block(UNIT), 50e3, force, 8, false);
    touch.hand.set(42.3, 48.4, 52);
    touch.run();
    touch.moveTo(42.3, 48.4, 45, 400);
    touch.moveTo(44.3, 48.4, 45, 400);
    Vec3 sum = new Vec3();
    for (int n = 0; n < 800; n++) {
      touch.hand.x += 0.01;
      touch.run();
      sum.add(touch.frame.forceNewton(), sum);
    }
    return sum.mul(1.0 / 800, sum);
  }

  @ParameterizedTest
  @EnumSource(FrictionForm.class)
  void frictionHoldsTheHandBackByItsShareOfThePressingForce(FrictionForm form) {
    Vec3 without = slidingForce(ForceSettings.of(0.5, 0));
    Vec3 with = slidingForce(new ForceSettings(0.5, 0.4, form, true));
    double expected = form.slidingFraction() * 0.4 * without.z;
    System.out.printf("friction %s: %.4f, expected %.4f N%n", form, without.x - with.x, expected);
    assertEquals(expected, without.x - with.x, 0.1 * expected);
    assertEquals(without.z, with.z, 0.05 * without.z);
  }

  @ParameterizedTest
  @CsvSource({"20e3, 0.5", "5e3, 2", "5e3, 4", "20e3, 4", "100e3, 4", "5e3, 0.25"})
  void comesToRestWithTheHand(double young, double k) {
    ElasticTouch touch = above(young, k, 8, true);
    touch.moveTo(48.3, 48.4, 45, 300);
    touch.moveTo(48.3, 48.4, 45, 1500);
    Vec3 before = new Vec3().set(touch.frame.forceNewton());
    double most = 0;
    for (int n = 0; n < 500; n++) {
      touch.run();
      most = Math.max(most, touch.frame.forceNewton().sub(before, new Vec3()).length());
    }
    System.out.printf("at rest, E %.0f k %.1f: %.5f of %.3f N%n", young, k, most, before.length());
    assertTrue(most < 0.02 * before.length(), "swings by " + most + " N of " + before.length());
  }

  /** Work that the hand does, and gets back, by the mean force of two frames times its motion. */
  private static final class Work {
    private final ElasticTouch touch;
    private final Vec3 lastHand = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private double taken;
    private double returned;

    Work(ElasticTouch touch) {
      this.touch = touch;
      lastHand.set(touch.hand);
    }

    void moveTo(double x, double z, double speedMmPerFrame) {
      Vec3 from = new Vec3().set(touch.hand);
      int frames = (int) Math.ceil(Math.hypot(x - from.x, z - from.z) / speedMmPerFrame);
      for (int n = 1; n <= frames; n++) {
        double t = (double) n / frames;
        touch.hand.set(from.x + t * (x - from.x), from.y, from.z + t * (z - from.z));
        touch.run();
        Vec3 motion = touch.hand.sub(lastHand, new Vec3());
        double work = 0.5 * motion.dot(lastForce.add(touch.frame.forceNewton(), new Vec3()));
        taken += Math.max(0, -work);
        returned += Math.max(0, work);
        lastHand.set(touch.hand);
        lastForce.set(touch.frame.forceNewton());
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "20e3, 0.01, 0",
    "20e3, 0.06, 0",
    "20e3, 0.2, 0",
    "20e3, 0.5, 0",
    "20e3, 0.06, 16",
    "5e3, 0.2, 0",
    "100e3, 0.2, 0",
    "1e6, 0.2, 8"
  })
  void noPressAndReleaseReturnsMoreWorkThanItTook(double young, double speed, double slide) {
    ElasticTouch touch = above(young, 0.5, 8, false);
    Work work = new Work(touch);
    work.moveTo(48.3, 41, speed);
    for (int n = 0; n < 200; n++) {
      touch.run();
    }
    work.lastForce.set(touch.frame.forceNewton());
    work.moveTo(48.3 + slide, 41, speed);
    work.moveTo(48.3 + slide, 52, speed);
    System.out.printf(
        "work, E %.0f, %.2f mm a frame, slide %.0f: %.4f of %.4f mJ, lowered %d%n",
        young, speed, slide, work.returned, work.taken, touch.body.contact().loweredFrames());
    assertTrue(work.taken > 1, "taken " + work.taken);
    assertTrue(work.returned <= 1.01 * work.taken, work.returned + " of " + work.taken);
  }

  @Test
  void framesAndUpdatesAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    ElasticTouch touch = above(20e3, 0.5, 8, true);
    touch.moveTo(48.3, 48.4, 44, 400);
    long least = Long.MAX_VALUE;
    ElasticLoad load = new ElasticLoad();
    Vec3 newton = new Vec3();
    for (int round = 0; round < 6; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int n = 0; n < 2000; n++) {
        touch.hand.z = 44 + Math.sin(n * 0.01);
        touch.body.contact().begin(touch.hand, touch.frame.point(), 0.5);
        touch.body.contact().follow(touch.solver, touch.scene, touch.frame.point(), 0.5);
        newton.set(0, 0, Math.max(0, 48 - touch.hand.z));
        touch.body.contact().limitWork(touch.hand, touch.frame.point(), 0.5, newton);
        if (n % 100 == 0) {
          touch.body.loads().read(load);
          touch.body.updater().update(load);
        }
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, least);
  }
}
