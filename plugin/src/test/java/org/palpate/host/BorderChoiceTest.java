package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.SwapEdit;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

class BorderChoiceTest {
  private static final long PERIOD_NANOS = 1_000_000;
  private static final int FRAMES = 4_000;
  private static final DeviceSpecification DEVICE =
      new DeviceSpecification("test", "", 3, 0.8, 80, PERIOD_NANOS);

  @ParameterizedTest
  @EnumSource(names = {"DOT", "PAPER"})
  void framesAreTheSameWhileTheSolidsAreEdited(SolverKind solver) {
    double[] onTheFly = run(solver, BorderChoice.ON_THE_FLY);
    assertTrue(onTheFly[3 * FRAMES] > FRAMES / 8.0, "frames in contact: " + onTheFly[3 * FRAMES]);
    assertArrayEquals(onTheFly, run(solver, BorderChoice.PRECALCULATED));
  }

  /** Returns the positions of all frames, and the number of frames in contact. */
  private static double[] run(SolverKind solver, BorderChoice border) {
    ContactScene scene =
        new ContactScene(
            Phantom.parse("sphere:48").segments(),
            ContactSettings.builder(solver).border(border).build());
    double[] result = new double[3 * FRAMES + 1];
    FramePublisher publisher =
        (device, point, force, contact, n) -> {
          for (int axis = 0; axis < 3; axis++) {
            result[3 * (int) n + axis] = point.get(axis);
          }
          result[3 * FRAMES] += contact ? 1 : 0;
        };
    PointFrame frame =
        scene.newFrame(
            GridDevice.fromWorld(
                new SimulatedDevice(1, scene.handTarget(), PERIOD_NANOS), scene.grid()),
            scene.liveFrame(DEVICE, 0.4),
            publisher);
    SplittableRandom random = new SplittableRandom(3);
    for (int n = 0; n < FRAMES; n++) {
      if (n % 20 == 0) {
        edit(scene, random);
      }
      if (n == FRAMES / 2) {
        scene.edits().offer(new SwapEdit(0, torus()));
      }
      frame.run(n * PERIOD_NANOS);
    }
    return result;
  }

  private static BitCube torus() {
    return Phantom.parse("torus:48").segments().segments().get(0).bits();
  }

  private static void edit(ContactScene scene, SplittableRandom random) {
    Vec3 centre =
        new Vec3(random.nextDouble(8, 40), random.nextDouble(8, 40), random.nextDouble(8, 40));
    scene.edits().offer(new BrushEdit(0, centre, 2, random.nextBoolean()));
  }

  @Test
  void parsesTheNamesOfTheCommandLine() {
    for (BorderChoice choice : BorderChoice.values()) {
      assertEquals(Optional.of(choice), BorderChoice.parse(choice.toString()));
    }
    assertEquals("on-the-fly", BorderChoice.ON_THE_FLY.toString());
    assertEquals(Optional.empty(), BorderChoice.parse("sometimes"));
  }
}
