package org.palpate.assess;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.frame.FrameRecord;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

class SessionAssessorTest {
  private static final int BONE = 0;
  private static final int NERVE = 1;

  private final SessionAssessor assessor = new SessionAssessor(3, Set.of(NERVE));
  private final FrameRecord frame = new FrameRecord();

  /** Adds frames up to a time, exclusive. */
  private void run(double hertz, double fromSeconds, double toSeconds) {
    for (long n = Math.round(fromSeconds * hertz); n < Math.round(toSeconds * hertz); n++) {
      frame.timeNanos = Math.round(n * 1e9 / hertz);
      assessor.accept(frame);
    }
  }

  private void touch(double newton, double ofBone, double ofNerve) {
    frame.contact = newton > 0;
    frame.pressingNewton = newton;
    frame.clearContacts();
    if (ofBone > 0) {
      frame.addContact(BONE, ofBone);
    }
    if (ofNerve > 0) {
      frame.addContact(NERVE, ofNerve);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {100, 1000, 5000, 10_000})
  void forcesOfSegmentsAreThoseOfTheirSharesAtEveryRate(double hertz) {
    touch(0, 0, 0);
    run(hertz, 0, 1);
    touch(2, 1, 0);
    run(hertz, 1, 2);
    touch(4, 0.25, 0.75);
    run(hertz, 2, 2.5);
    touch(0, 0, 0);
    run(hertz, 2.5, 3);
    touch(1, 1, 0);
    run(hertz, 3, 4);
    assessor.finish();
    ContactStatistics bone = assessor.contacts(BONE);
    assertEquals(2.5, bone.seconds(), 1e-6);
    assertEquals(2, bone.contacts());
    assertEquals((2 * 1 + 1 * 0.5 + 1 * 1) / 2.5, bone.meanNewton(), 1e-6);
    assertEquals(2, bone.largestNewton());
    assertEquals(1, bone.largestAtSeconds(), 1e-9);
    ContactStatistics nerve = assessor.contacts(NERVE);
    assertEquals(0.5, nerve.seconds(), 1e-6);
    assertEquals(3, nerve.meanNewton(), 1e-6);
    assertEquals(2, nerve.largestAtSeconds(), 1e-9);
    assertEquals(0, assessor.contacts(2).contacts());
    assertEquals((2 + 4 * 0.5 + 1) / 2.5, assessor.contacts().meanNewton(), 1e-6);
    assertEquals(4, assessor.exceededNewton(0.05), "not above the largest force");
    assertEquals(2, assessor.exceededNewton(0.5), 0.01);
  }

  @Test
  void aPointThatPressesBetweenVoxelsTouchesWhatItTouchedLast() {
    touch(1, 0, 1);
    run(1000, 0, 0.1);
    touch(1, 0, 0);
    frame.contact = true;
    run(1000, 0.1, 0.2);
    touch(0, 0, 0);
    run(1000, 0.2, 0.3);
    frame.contact = true;
    run(1000, 0.3, 0.4);
    assertEquals(1, assessor.contacts(NERVE).contacts());
    assertEquals(0.199, assessor.contacts(NERVE).seconds(), 1e-6);
    assertEquals(0.299, assessor.contacts().seconds(), 1e-6, "even if nobody knows with what");
  }

  @Test
  void whatTheHandHeldIsNotedWithItsMotion() {
    run(1000, 0, 1);
    frame.heldBody = 2;
    frame.tool.translation.set(5, 5, 5);
    run(1000, 1, 2);
    frame.tool.translation.set(5, 8, 9);
    frame.tool.rotation.setRotationVector(new Vec3(0, 0.5, 0));
    run(1000, 2, 2.5);
    frame.heldBody = -1;
    run(1000, 2.5, 3);
    frame.heldBody = 0;
    run(1000, 3, 4);
    assessor.finish();
    Hold first = assessor.holds().get(0);
    assertEquals(2, first.body());
    assertEquals(1, first.fromSeconds(), 1e-9);
    assertEquals(2.499, first.toSeconds(), 1e-9);
    assertEquals(5, first.movedMm(), 1e-12);
    assertEquals(0.5, first.turnedRad(), 1e-12);
    assertEquals(2, assessor.holds().size(), "the last hold ends with the session");
    assertEquals(3.999, assessor.holds().get(1).toSeconds(), 1e-9);
  }

  @Test
  void jumpsAreNoPath() {
    run(1000, 0, 1);
    frame.freed = true;
    frame.tool.translation.set(7, 0, 0);
    run(1000, 1, 1.001);
    frame.freed = false;
    frame.relocated = true;
    frame.deviceMm.set(0, 9, 0);
    run(1000, 1.001, 1.002);
    frame.relocated = false;
    run(1000, 1.002, 2);
    assessor.finish();
    assertEquals(0, assessor.toolPathMm(), 1e-12);
    assertEquals(0, assessor.handPathMm(), 1e-12);
    assertEquals(1, assessor.freed());
  }

  /** Compares the course of a long session with the frames of each of its rows. */
  @Test
  void aLongCourseHasTheForcesOfItsFramesInFewRows() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    int count = 100_000;
    double[] newton = new double[count];
    double hertz = 500;
    for (int n = 0; n < count; n++) {
      newton[n] = random.nextInt(4) == 0 ? random.nextDouble(5) : 0;
      touch(newton[n], 0.5, n % 3 == 0 ? 0.5 : 0);
      run(hertz, n / hertz, (n + 1) / hertz);
    }
    SessionCourse course = assessor.course();
    assertTrue(course.rows() <= SessionCourse.MOST && course.rows() > SessionCourse.MOST / 4);
    long merged = Math.round((course.seconds(1) - course.seconds(0)) / 0.01);
    for (int row = 0; row < course.rows(); row++) {
      double largest = 0;
      double sum = 0;
      int frames = 0;
      int forbidden = 0;
      for (int n = 0; n < count; n++) {
        if ((long) (Math.round(n * 1e9 / hertz) / 1e9 / 0.01) / merged == row) {
          largest = Math.max(largest, newton[n]);
          sum += newton[n];
          forbidden += newton[n] > 0 && n % 3 == 0 ? 1 : 0;
          frames++;
        }
      }
      assertEquals(largest, course.largestNewton(row), "seed " + Seeds.seed() + " row " + row);
      assertEquals(sum / frames, course.meanNewton(row), 1e-12);
      assertEquals((double) forbidden / frames, course.forbidden(row), 1e-12);
    }
  }
}
