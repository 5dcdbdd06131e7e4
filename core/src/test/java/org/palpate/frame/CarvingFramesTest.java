package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Cuts with whole frames of a point and of a burr. */
class CarvingFramesTest {
  private static final int EDGE = 24;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
  private static final double STIFFNESS = 0.5;

  private final BitCube wall = slab(12, 12);
  private final EditQueue edits = EditQueue.ofBodies(List.of(GRID));
  private final Vec3 position = new Vec3(12, 12, 20);
  private final ScriptedDevice device = new ScriptedDevice((read, state) -> read(state));
  private long nowNanos = 1;

  @Test
  void aBurrDrillsThroughAWallOfOneVoxelAndLeavesTheRest() {
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(100));
    run(frame, 5);
    position.z = 4;
    run(frame, 4000);
    assertEquals(4, frame.motion().pose().translation.z, 1e-9);
    assertFalse(wall.get(12, 12, 12));
    for (int j = 0; j < EDGE; j++) {
      for (int i = 0; i < EDGE; i++) {
        double fromAxis =
            Math.hypot(
                Math.max(0, Math.abs(i - 11.5) - 0.5), Math.max(0, Math.abs(j - 11.5) - 0.5));
        assertTrue(fromAxis < 3 + 1.4 || wall.get(i, j, 12), "voxel " + i + "," + j + " is far");
      }
    }
    assertEquals(0, frame.statistics().freed());
  }

  @Test
  void withoutCuttingTheSameHandIsStopped() {
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(0));
    run(frame, 5);
    position.z = 4;
    run(frame, 1000);
    assertTrue(frame.motion().pose().translation.z > 16);
    assertEquals(EDGE * EDGE, wall.solidCount());
  }

  @Test
  void removesNoMoreThanForceTimeAndRateAllow() {
    double rate = 5;
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(rate));
    run(frame, 5);
    double allowedMm3 = 0;
    position.z = 15;
    for (int n = 0; n < 3000; n++) {
      allowedMm3 += rate * device.lastForce().length() * 1e-3;
      run(frame, 1);
      long removed = EDGE * EDGE - wall.solidCount();
      assertTrue(removed <= allowedMm3, removed + " of " + allowedMm3 + " in frame " + n);
    }
    assertTrue(wall.solidCount() < EDGE * EDGE - 3, "some voxels were removed");
  }

  /**
   * A burr rests on the smooth surface, up to about one edge above the cells that block it. Legs of
   * one edge often end before them, so that a hand that slides cuts less than its force pays for.
   */
  @Test
  void aBurrThatSlidesOverACurvedSurfaceCutsAlmostAllThatItsForcePaysFor() {
    double rate = 200;
    BitCube ball = ball(8);
    long before = ball.solidCount();
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(rate), ball);
    run(frame, 5);
    double paidMm3 = 0;
    for (int n = 0; n < 3000; n++) {
      double angle = n * 0.004;
      position.set(12 + 3 * Math.cos(angle), 12 + 3 * Math.sin(angle), 12 + 8);
      run(frame, 1);
      paidMm3 += rate * device.lastForce().length() * 1e-3;
    }
    long removed = before - ball.solidCount();
    assertTrue(paidMm3 > 20, "paid " + paidMm3);
    assertTrue(removed > 0.9 * paidMm3, removed + " of " + paidMm3);
  }

  private static BitCube ball(double radius) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      if (GRID.metric().distance(i, j, k, 11.5, 11.5, 11.5) <= radius) {
        bits.set(i, j, k);
      }
    }
    return bits;
  }

  @Test
  void aForceBelowTheThresholdMeetsAHardWall() {
    double pressed = STIFFNESS * 2;
    for (double least : new double[] {0.8 * pressed, 3 * pressed}) {
      BitCube before = wall.copy();
      ToolFrame frame = toolFrame(burr(), new CarveSettings(100, List.of(least), null));
      position.z = 20;
      run(frame, 5);
      position.z = 14;
      run(frame, 500);
      assertEquals(least < pressed, wall.solidCount() < before.solidCount(), "least " + least);
      if (least < pressed) {
        restore(before);
      }
    }
  }

  private void restore(BitCube before) {
    for (int k = 0; k < EDGE / 4; k++) {
      for (int j = 0; j < EDGE / 4; j++) {
        for (int i = 0; i < EDGE / 4; i++) {
          wall.setBrick(i, j, k, before.brick(i, j, k));
        }
      }
    }
  }

  @Test
  void keptVoxelsStayWhateverThePressure() {
    BitCube kept = new BitCube(EDGE, EDGE, EDGE);
    for (int j = 0; j < EDGE; j++) {
      kept.set(11, j, 12);
    }
    ToolFrame frame = toolFrame(burr(), new CarveSettings(1e4, List.of(), kept));
    run(frame, 5);
    position.z = -20;
    for (int n = 0; n < 2000; n++) {
      position.x = 12 + 6 * Math.sin(n * 0.01);
      run(frame, 1);
    }
    for (int j = 0; j < EDGE; j++) {
      assertTrue(wall.get(11, j, 12));
    }
    assertTrue(wall.solidCount() < EDGE * EDGE - 20);
  }

  @Test
  void aStrokeOfTheBurrIsUndoneAndTheToolInsideWhatIsFilledIsSetFree() {
    BitCube before = wall.copy();
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(1000));
    run(frame, 5);
    position.z = 12;
    run(frame, 2000);
    assertTrue(wall.solidCount() < before.solidCount());
    assertTrue(edits.offer(HistoryEdit.undo()));
    run(frame, 1);
    assertEquals(before.solidCount(), wall.solidCount());
    assertEquals(before.brick(3, 3, 3), wall.brick(3, 3, 3));
    assertTrue(frame.wasFreed());
  }

  @Test
  void aBallThatIsFilledAroundTheToolSetsItFree() {
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(100));
    run(frame, 5);
    assertTrue(edits.offer(new BrushEdit(0, position, 2, true)));
    run(frame, 1);
    assertTrue(frame.wasFreed());
  }

  @Test
  void aPointDrillsThroughAWallOfOneVoxelByOneVoxel() {
    PointFrame frame = pointFrame(CarveSettings.ofRate(100));
    position.set(12.3, 12.4, 20);
    run(frame, 5);
    position.z = 4;
    run(frame, 300);
    assertEquals(4, frame.point().position.z);
    assertEquals(EDGE * EDGE - 1, wall.solidCount());
    assertFalse(wall.get(12, 12, 12));
  }

  @Test
  void theSameInputCutsTheSameVoxelsAndEndsAtTheSameBits() {
    ToolFrame first = drill(new BitCube[] {wall});
    BitCube again = slab(12, 12);
    ToolFrame second = drill(new BitCube[] {again});
    assertTrue(first.motion().pose().sameBits(second.motion().pose()));
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      assertEquals(wall.get(i, j, k), again.get(i, j, k));
    }
  }

  private ToolFrame drill(BitCube[] bits) {
    position.set(12, 12, 20);
    ToolFrame frame = toolFrame(burr(), CarveSettings.ofRate(30), bits[0]);
    for (int n = 0; n < 1500; n++) {
      position.set(12 + Math.sin(n * 0.02), 12, 20 - n * 0.01);
      run(frame, 1);
    }
    return frame;
  }

  private static BitCube slab(int low, int high) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE; n++) {
      for (int k = low; k <= high; k++) {
        bits.set(n % EDGE, n / EDGE, k);
      }
    }
    return bits;
  }

  private static RigidTool burr() {
    return ToolSampler.ofShape(RodShape.sphere(3), 0.498);
  }

  private ToolFrame toolFrame(RigidTool tool, CarveSettings carve) {
    return toolFrame(tool, carve, wall);
  }

  private ToolFrame toolFrame(RigidTool tool, CarveSettings carve, BitCube bits) {
    BodyScene bodies = new BodyScene(List.of(new Body("wall", bits, GRID, Mobility.FIXED)));
    ToolFrame frame =
        new ToolFrame(
            device,
            bodies,
            new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(5, bodies, tool)),
            RigidCoupling.of(tool, STIFFNESS),
            settings(),
            edits,
            ToolFramePublisher.NONE);
    frame.carve(carve);
    return frame;
  }

  private PointFrame pointFrame(CarveSettings carve) {
    GridMetric metric = GRID.metric();
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            new GuardedSolver(metric, 5),
            new CollisionScene(List.of(wall)),
            metric,
            settings(),
            edits,
            FramePublisher.NONE);
    frame.carve(carve);
    return frame;
  }

  private static FrameSettings settings() {
    double infinite = Double.POSITIVE_INFINITY;
    return new FrameSettings(
        ForceSettings.of(STIFFNESS, 0), infinite, infinite, 0, FrameSettings.NO_SILENCE, 1 << 20);
  }

  private ReadStatus read(DeviceState state) {
    state.orientation.setIdentity();
    return fresh(state, nowNanos / ManualClock.MS, position.x, position.y, position.z);
  }

  private void run(HapticFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      nowNanos += ManualClock.MS;
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
    }
  }
}
