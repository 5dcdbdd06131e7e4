package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.SimulatedDevice;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.volume.phantom.Phantom;

class ContactTuningTest {
  private static final long PERIOD_NANOS = 1_000_000;
  private static final DeviceSpecification DEVICE =
      new DeviceSpecification("test", "", 3, 0.8, 80, PERIOD_NANOS);

  private final ContactScene scene =
      new ContactScene(
          Phantom.parse("sphere:48").segments(), ContactSettings.standard(SolverKind.GUARDED));
  private final PointFrame frame =
      scene.newFrame(
          GridDevice.fromWorld(
              new SimulatedDevice(1, scene.handTarget(), PERIOD_NANOS), scene.grid()),
          scene.liveFrame(DEVICE, 0.4),
          FramePublisher.NONE);
  private final ContactTuning tuning =
      new ContactTuning(frame, scene, ForceSettings.of(0.4, 0.2), DEVICE, false);

  @Test
  void neverExceedsTheStiffnessOfTheDevice() {
    for (int i = 0; i < 20; i++) {
      tuning.increaseStiffness();
    }
    assertEquals(0.8, tuning.force().stiffnessNewtonPerMm());
    for (int i = 0; i < 100; i++) {
      tuning.decreaseStiffness();
    }
    assertTrue(tuning.force().stiffnessNewtonPerMm() > 0);
  }

  @Test
  void keepsFrictionBetweenZeroAndOne() {
    for (int i = 0; i < 40; i++) {
      tuning.increaseFriction();
    }
    assertEquals(1, tuning.force().friction());
    for (int i = 0; i < 40; i++) {
      tuning.decreaseFriction();
    }
    assertEquals(0, tuning.force().friction());
  }

  @Test
  void switchesSolversBetweenFramesWithoutEnteringASolid() {
    assertEquals(SolverKind.GUARDED, tuning.solver().orElseThrow());
    assertEquals("next solver: smooth, guarded, paper, dot", tuning.solverHelp().orElseThrow());
    long now = 0;
    for (int change = 0; change < 40; change++) {
      tuning.nextSolver();
      for (int n = 0; n < 250; n++) {
        now += PERIOD_NANOS;
        assertEquals(FrameOutcome.RUNNING, frame.run(now));
        SolverKind solver = tuning.solver().orElseThrow();
        if (solver == SolverKind.GUARDED || solver == SolverKind.SMOOTH) {
          var p = frame.point().position;
          boolean touches = scene.newCollisionScene().touches(p.x, p.y, p.z);
          assertTrue(!touches, solver + " change " + change + " frame " + n);
        }
      }
    }
    assertTrue(frame.statistics().contactFrames() > 1000);
  }
}
