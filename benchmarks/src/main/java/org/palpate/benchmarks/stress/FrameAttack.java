package org.palpate.benchmarks.stress;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Attacks whole frames: a {@link FaultyDevice}, a clock that jumps, edits of voxels, balls and
 * whole segments around the interaction point, and changing solvers.
 *
 * <p>It checks the promises. A leg touches no voxel that is solid at that time. A chain of legs
 * breaks only where the point was set free. Forces are finite, within the device's maximum, and
 * zero at the end. The same seed gives the same bits. One thread.
 */
public final class FrameAttack {
  private static final int FRAMES_PER_CASE = 1000;
  private static final double STIFFNESS_NEWTON_PER_MM = 0.7;
  private static final double FRICTION = 0.4;

  private final ExactJudge judge = new ExactJudge();
  private long cases;
  private long frames;
  private long legs;
  private long freed;
  private long edits;

  /** Returns the number of frames. */
  public long frames() {
    return frames;
  }

  /** Returns the number of legs. */
  public long legs() {
    return legs;
  }

  /** Returns how often a point was set free. */
  public long freed() {
    return freed;
  }

  /** Returns the number of edits that were applied. */
  public long edits() {
    return edits;
  }

  /**
   * Runs whole cases until the total number of frames is reached.
   *
   * @return the first fault with its case, or null
   */
  public String untilFrames(long seed, long wanted) {
    while (frames < wanted) {
      String fault = new Case(seed * 0x9E3779B97F4A7C15L + cases++).run();
      if (fault != null) {
        return fault + " (case " + (cases - 1) + " of seed " + seed + ")";
      }
    }
    return null;
  }

  /** One scene with its device. */
  private final class Case {
    private final SplittableRandom random;
    private final HostileScene scene;
    private final FaultyDevice device;
    private final CollisionScene collisionScene;
    private final EditQueue queue;
    private final PointFrame frame;
    private final Vec3 before = new Vec3();
    private final Vec3 at = new Vec3();
    private final Vec3 start = new Vec3();
    private boolean placed;
    private long nowNanos;

    Case(long seed) {
      random = new SplittableRandom(seed);
      scene = HostileScene.next(random);
      BitCube bits = scene.bits();
      HostileHand hand = new HostileHand(random.split(), bits);
      device = new FaultyDevice(random.split(), hand, new Vec3(0.5, 0.5, 0.5));
      collisionScene = new CollisionScene(List.of(bits));
      Vec3 spacing = scene.spacingMm();
      VoxelGrid grid =
          new VoxelGrid(
              bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, RigidTransform.identity());
      queue = new EditQueue(grid, 1);
      frame =
          new PointFrame(
              GridDevice.inGridCoordinates(device),
              newSolver(),
              collisionScene,
              scene.metric(),
              FrameSettings.live(
                  device.specification(), ForceSettings.of(STIFFNESS_NEWTON_PER_MM, FRICTION)),
              queue,
              FramePublisher.NONE);
      device.aimAt(frame.point());
    }

    private ProxySolver newSolver() {
      return random.nextBoolean()
          ? new GuardedSolver(scene.metric(), scene.maxStepMm())
          : new SmoothSolver(scene.metric(), scene.maxStepMm());
    }

    String run() {
      FrameOutcome outcome = FrameOutcome.RUNNING;
      for (int n = 0; n < FRAMES_PER_CASE && outcome == FrameOutcome.RUNNING; n++) {
        disturb();
        nowNanos += step();
        before.set(frame.point().position);
        outcome = frame.run(nowNanos); // may end if a lost write meets a long gap
        frames++;
        String fault = fault();
        if (fault != null) {
          return fault + ", frame " + n + " on " + scene.kind();
        }
      }
      edits += queue.completed();
      frame.release();
      return device.lastForce().length() == 0 ? null : "the last force is not zero";
    }

    private long step() {
      return switch (random.nextInt(200)) {
        case 0 -> random.nextLong(60_000_000); // a late frame, sometimes a silence
        case 1 -> -random.nextLong(3_000_000);
        case 2 -> 0;
        default -> 1_000_000;
      };
    }

    private void disturb() {
      if (random.nextInt(25) == 0) {
        queue.offer(edit());
      }
      if (random.nextInt(150) == 0) {
        frame.requestSolver(newSolver());
      }
      if (random.nextInt(150) == 0) {
        frame.requestForce(ForceSettings.of(10 * random.nextDouble(), random.nextDouble()));
      }
    }

    private Edit edit() {
      BitCube bits = scene.bits();
      Vec3 p = frame.point().position;
      boolean solid = random.nextInt(3) != 0;
      return switch (random.nextInt(5)) {
        case 0 -> new SwapEdit(0, otherBits());
        case 1, 2 -> brush(p, solid);
        default ->
            new VoxelEdit(
                0,
                near(p.x, bits.sizeX()),
                near(p.y, bits.sizeY()),
                near(p.z, bits.sizeZ()),
                solid);
      };
    }

    private Edit brush(Vec3 p, boolean solid) {
      BitCube bits = scene.bits();
      Vec3 centre =
          new Vec3(
              near(p.x, bits.sizeX()) + 0.5,
              near(p.y, bits.sizeY()) + 0.5,
              near(p.z, bits.sizeZ()) + 0.5);
      double shortest =
          Math.min(scene.spacingMm().x, Math.min(scene.spacingMm().y, scene.spacingMm().z));
      return new BrushEdit(0, centre, shortest * (0.3 + 3 * random.nextDouble()), solid);
    }

    /** Returns the point's voxel or one next to it, within the grid. */
    private int near(double coordinate, int size) {
      double voxel = Math.floor(coordinate) + random.nextInt(-1, 2);
      return (int) Math.max(0, Math.min(size - 1, voxel));
    }

    private BitCube otherBits() {
      BitCube bits = collisionScene.cube(0).copy();
      for (int n = 0; n < 200; n++) {
        int i = random.nextInt(bits.sizeX());
        int j = random.nextInt(bits.sizeY());
        int k = random.nextInt(bits.sizeZ());
        if (random.nextBoolean()) {
          bits.set(i, j, k);
        } else {
          bits.clear(i, j, k);
        }
      }
      return bits;
    }

    private String fault() {
      freed += frame.wasFreed() ? 1 : 0;
      Vec3 force = device.lastForce();
      if (!(force.length() <= FaultyDevice.MAX_FORCE_NEWTON * (1 + 1e-12))) {
        return "force " + force;
      }
      boolean begins = !placed || frame.wasFreed();
      placed |= frame.followed();
      String fault = faultOfLegs(begins);
      Vec3 p = frame.point().position;
      return fault == null && placed && collisionScene.touches(p.x, p.y, p.z)
          ? "the point touches a solid"
          : fault;
    }

    /**
     * Returns the fault of the frame's legs, or null.
     *
     * @param begins whether a new chain may start away from the point's last position
     */
    private String faultOfLegs(boolean begins) {
      LegPath path = frame.point().legs;
      at.set(before);
      for (int leg = 0; leg < path.count(); leg++) {
        legs++;
        start.set(path.start(leg, 0), path.start(leg, 1), path.start(leg, 2));
        if (!start.sameBits(at) && !(begins && leg == 0)) {
          return "leg " + leg + " does not start where the last one ended";
        }
        if (judge.touches(collisionScene.cube(0), path, leg)) {
          return "leg " + leg + " touches a solid";
        }
        at.set(path.end(leg, 0), path.end(leg, 1), path.end(leg, 2));
      }
      boolean ends = at.sameBits(frame.point().position) || (begins && path.count() == 0);
      return ends ? null : "the point is not where its last leg ended";
    }
  }
}
