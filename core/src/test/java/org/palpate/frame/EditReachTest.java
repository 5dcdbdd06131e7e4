package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.GreyEdit;
import org.palpate.edit.HistoryEdit;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.statistics.SkipCounters;
import org.palpate.testing.Floor;
import org.palpate.testing.RandomCases;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A solver that keeps what an edit does not reach gives the same points and forces, to the bit, as
 * a solver that forgets everything. Edits change voxels, balls, grey values or all bits, undo or
 * redo, and cut.
 */
class EditReachTest {
  private static final int EDGE = 48;
  private static final double RADIUS_MM = 18;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  /** A frame with its own solids, and the queue of its edits. */
  private static final class Session {
    final VoxelGrid grid;
    final BitCube bits;
    final CollisionScene scene;
    final EditQueue edits;
    final Vec3 deviceMm = new Vec3();
    final ScriptedDevice device;
    final GreyIsosurfaceSource grey;
    final WatchedSolver solver;
    final PointFrame frame;

    Session(Vec3 spacingMm, boolean forgetsAll, boolean isGrey) {
      grid =
          new VoxelGrid(
              (int) Math.ceil(EDGE / spacingMm.x),
              (int) Math.ceil(EDGE / spacingMm.y),
              (int) Math.ceil(EDGE / spacingMm.z),
              spacingMm,
              RigidTransform.identity());
      bits = ball(0);
      grey = new GreyIsosurfaceSource(greyBall(0));
      scene = new CollisionScene(List.of(bits));
      edits = new EditQueue(grid, 1);
      device =
          new ScriptedDevice(
              (read, state) ->
                  ScriptedDevice.fresh(
                      state,
                      read,
                      deviceMm.x / spacingMm.x,
                      deviceMm.y / spacingMm.y,
                      deviceMm.z / spacingMm.z));
      GridMetric metric = GridMetric.of(spacingMm);
      SmoothSolver smooth =
          isGrey ? new SmoothSolver(metric, 8, grey) : new SmoothSolver(metric, 8);
      solver = new WatchedSolver(smooth, forgetsAll);
      frame =
          new PointFrame(
              GridDevice.inGridCoordinates(device),
              solver,
              scene,
              metric,
              Floor.settings(),
              edits,
              FramePublisher.NONE);
    }

    /** Returns a ball whose middle is moved along x. */
    BitCube ball(double moved) {
      BitCube ball = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
      for (int k = 0; k < grid.sizeZ(); k++) {
        for (int j = 0; j < grid.sizeY(); j++) {
          for (int i = 0; i < grid.sizeX(); i++) {
            if (outsideMm(i, j, k, moved) < 0) {
              ball.set(i, j, k);
            }
          }
        }
      }
      return ball;
    }

    GreyIsosurface greyBall(double moved) {
      ScalarVolume volume = ScalarVolume.of(grid, ScalarVolume.Storage.INT16);
      for (int k = 0; k < grid.sizeZ(); k++) {
        for (int j = 0; j < grid.sizeY(); j++) {
          for (int i = 0; i < grid.sizeX(); i++) {
            volume.set(i, j, k, 100 - 80 * Math.tanh(outsideMm(i, j, k, moved)));
          }
        }
      }
      return new GreyIsosurface(volume, 100, 100);
    }

    private double outsideMm(int i, int j, int k, double moved) {
      double x = (i + 0.5) * grid.spacingMm().x - EDGE / 2.0 - moved;
      double y = (j + 0.5) * grid.spacingMm().y - EDGE / 2.0;
      double z = (k + 0.5) * grid.spacingMm().z - EDGE / 2.0;
      return Math.sqrt(x * x + y * y + z * z) - RADIUS_MM;
    }

    void run(int number) {
      assertEquals(FrameOutcome.RUNNING, frame.run(number * ManualClock.MS));
    }
  }

  /** Adds up the work of a solver, which may be made to forget everything after each edit. */
  private static final class WatchedSolver implements ProxySolver {
    private final SmoothSolver solver;
    private final boolean forgetsAll;

    /** The work of all frames. */
    long steps;

    /** The number of times that it forgot all or something. */
    int resets;

    WatchedSolver(SmoothSolver solver, boolean forgetsAll) {
      this.solver = solver;
      this.forgetsAll = forgetsAll;
    }

    @Override
    public void follow(CollisionScene scene, Vec3 device, InteractionPoint point) {
      solver.follow(scene, device, point);
      steps += solver.steps();
    }

    @Override
    public void reset() {
      resets++;
      solver.reset();
    }

    @Override
    public void resetAfterEdit(IntBox changed) {
      resets++;
      if (forgetsAll) {
        solver.reset();
      } else {
        solver.resetAfterEdit(changed);
      }
    }

    @Override
    public void addSkips(SkipCounters dest) {
      solver.addSkips(dest);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, false",
    "1, 1, 1.2, false",
    "1, 1, 2, false",
    "1, 1, 5, false",
    "1, 2, 2, false",
    "1, 1, 1, true",
    "1, 1, 2, true"
  })
  void framesAmongEditsAreThoseOfASolverThatForgetsAll(
      double x, double y, double z, boolean isGrey) {
    Vec3 spacingMm = new Vec3(x, y, z);
    Session kept = new Session(spacingMm, false, isGrey);
    Session plain = new Session(spacingMm, true, isGrey);
    kept.frame.carve(CarveSettings.ofRate(20));
    plain.frame.carve(CarveSettings.ofRate(20));
    for (int n = 1; n <= RandomCases.of(1500); n++) {
      place(n, kept.deviceMm);
      plain.deviceMm.set(kept.deviceMm);
      if (n % 5 == 0) {
        offer(kept, plain);
      }
      if (n % 10 == 0) {
        offer(kept, plain); // Two edits in one frame: each reaches other voxels.
      }
      kept.run(n);
      plain.run(n);
      String where = "seed=" + Seeds.seed() + " frame " + n;
      assertTrue(kept.frame.point().position.sameBits(plain.frame.point().position), where);
      assertTrue(kept.device.lastForce().sameBits(plain.device.lastForce()), where);
    }
    assertTrue(kept.frame.statistics().contactFrames() > RandomCases.of(500), "in contact");
    assertNotEquals(kept.ball(0).solidCount(), kept.scene.cube(0).solidCount(), "edits and cuts");
    assertTrue(
        kept.solver.steps <= plain.solver.steps,
        kept.solver.steps + " steps of " + plain.solver.steps);
  }

  /** The solver forgets nothing then, so no frame takes more work or moves the point. */
  @ParameterizedTest
  @CsvSource({"1, false", "1.2, false", "1, true"})
  void editsThatChangeNothingLeaveFramesAsTheyAre(double z, boolean isGrey) {
    Session edited = new Session(new Vec3(1, 1, z), false, isGrey);
    Session plain = new Session(new Vec3(1, 1, z), false, isGrey);
    for (int n = 1; n <= 400; n++) {
      place(n, edited.deviceMm);
      plain.deviceMm.set(edited.deviceMm);
      boolean solid = n % 2 == 0;
      Vec3 inside = new Vec3(EDGE / 2.0, EDGE / 2.0, EDGE / 2.0 / z);
      Vec3 at = solid ? inside : new Vec3(1.5, 1.5, 1.5);
      Edit edit = n % 3 == 0 ? HistoryEdit.undo() : new BrushEdit(0, at, 1.5, solid);
      assertTrue(edited.edits.offer(edit));
      edited.run(n);
      plain.run(n);
      assertTrue(edited.frame.point().position.sameBits(plain.frame.point().position), "at " + n);
      assertTrue(edited.device.lastForce().sameBits(plain.device.lastForce()), "at " + n);
    }
    assertEquals(plain.solver.resets, edited.solver.resets);
    assertEquals(plain.solver.steps, edited.solver.steps);
    assertTrue(edited.frame.statistics().contactFrames() > 100, "in contact");
    assertTrue(edited.edits.completed() > 390, "edits were applied");
  }

  @Test
  void newGreyValuesMakeTheSolverForgetAllAlthoughNoVoxelChanges() {
    Session session = new Session(new Vec3(1, 1, 1), false, true);
    place(300, session.deviceMm);
    session.run(1);
    session.run(2);
    int before = session.solver.resets;
    assertTrue(session.edits.offer(new GreyEdit(0, session.grey, session.greyBall(0.5))));
    session.run(3);
    assertEquals(before + 1, session.solver.resets);
    session.run(4);
    assertEquals(before + 1, session.solver.resets, "it forgets once");
  }

  /** Presses on the ball and slides over it. */
  private static void place(int n, Vec3 deviceMm) {
    double radius = RADIUS_MM + Math.max(-2, 6 - 0.1 * n);
    double angle = 0.004 * n;
    double slope = 0.8 * Math.sin(0.003 * n);
    deviceMm.set(
        EDGE / 2.0 + radius * Math.cos(angle) * Math.cos(slope),
        EDGE / 2.0 + radius * Math.sin(angle) * Math.cos(slope),
        EDGE / 2.0 + radius * Math.sin(slope));
  }

  /** Offers the same edit to both. */
  private void offer(Session kept, Session plain) {
    double moved = random.nextDouble() - 0.5;
    Vec3 at = new Vec3();
    at.set(kept.frame.point().position);
    at.set(at.x + random.nextInt(-9, 10), at.y + random.nextInt(-9, 10), at.z);
    boolean solid = random.nextBoolean();
    double radiusMm = 0.8 + random.nextDouble();
    int i = Math.max(0, Math.min(kept.grid.sizeX() - 1, (int) at.x));
    int j = Math.max(0, Math.min(kept.grid.sizeY() - 1, (int) at.y));
    int k = Math.max(0, Math.min(kept.grid.sizeZ() - 1, (int) at.z));
    switch (random.nextInt(12)) {
      case 0, 1, 2 -> both(kept, plain, HistoryEdit::undo);
      case 3, 4 -> both(kept, plain, HistoryEdit::redo);
      case 5 -> {
        assertTrue(kept.edits.offer(new GreyEdit(0, kept.grey, kept.greyBall(moved))));
        assertTrue(plain.edits.offer(new GreyEdit(0, plain.grey, plain.greyBall(moved))));
      }
      case 6 -> both(kept, plain, () -> new SwapEdit(0, kept.ball(moved)));
      case 7, 8, 9 -> both(kept, plain, () -> new VoxelEdit(0, i, j, k, solid));
      default -> both(kept, plain, () -> new BrushEdit(0, new Vec3(i, j, k), radiusMm, solid));
    }
  }

  private static void both(Session kept, Session plain, Supplier<Edit> edit) {
    assertTrue(kept.edits.offer(edit.get()));
    assertTrue(plain.edits.offer(edit.get()));
  }

  /** An edit at the point is felt in the next frame, and takes less work. */
  @Test
  void anEditIsFeltInTheNextFrameAndTakesLessWork() {
    Session kept = new Session(new Vec3(1, 1, 1.2), false, false);
    Session plain = new Session(new Vec3(1, 1, 1.2), true, false);
    for (int n = 1; n <= 1200; n++) {
      place(n, kept.deviceMm);
      plain.deviceMm.set(kept.deviceMm);
      if (n > 200 && n % 4 == 0) {
        int i = (int) (kept.deviceMm.x - 0.5);
        int j = (int) (kept.deviceMm.y - 0.5);
        int k = (int) (kept.deviceMm.z / 1.2);
        both(kept, plain, () -> new VoxelEdit(0, i, j, k, false));
      }
      kept.run(n);
      plain.run(n);
      assertTrue(kept.device.lastForce().sameBits(plain.device.lastForce()), "frame " + n);
      assertTrue(kept.edits.isIdle(), "frame " + n + " applies the edit that waits");
    }
    assertTrue(
        1.2 * kept.solver.steps < plain.solver.steps,
        kept.solver.steps + " steps of " + plain.solver.steps);
  }
}
