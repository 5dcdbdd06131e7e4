package org.palpate.benchmarks.stress;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.BrushLimits;
import org.palpate.edit.BrushPath;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
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
 *
 * <p>In an attack with {@link #ofCuts} the point also cuts, brushes follow it, and strokes are
 * undone and redone. The voxels are then those of a plain copy, and protected ones never change.
 */
public final class FrameAttack {
  private static final int FRAMES_PER_CASE = 1000;
  private static final double STIFFNESS_NEWTON_PER_MM = 0.7;
  private static final double FRICTION = 0.4;

  /** The highest rate of cutting, voxels per N s. */
  private static final double MOST_VOXELS_RATE = 1e4;

  private final ExactJudge judge = new ExactJudge();
  private final boolean cuts;
  private long cases;
  private long frames;
  private long legs;
  private long freed;
  private long edits;
  private long changes;

  /** Creates an attack on frames that do not cut. */
  public FrameAttack() {
    this(false);
  }

  private FrameAttack(boolean cuts) {
    this.cuts = cuts;
  }

  /** Creates an attack on frames whose point cuts. */
  public static FrameAttack ofCuts() {
    return new FrameAttack(true);
  }

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

  /** Returns the number of voxels that changed in an attack with cuts. */
  public long changes() {
    return changes;
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

  /**
   * A point that cuts.
   *
   * @param nerve what it must not cut
   * @param copy follows the changes
   */
  private record Cutting(ProtectedVoxels nerve, PlainCopy copy) {}

  /** One scene with its device. */
  private final class Case {
    private final SplittableRandom random;
    private final HostileScene scene;
    private final Optional<Cutting> cutting;
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
      cutting = cuts ? Optional.of(newCutting()) : Optional.empty();
      HostileHand hand = new HostileHand(random.split(), bits);
      device = new FaultyDevice(random.split(), hand, new Vec3(0.5, 0.5, 0.5));
      collisionScene =
          new CollisionScene(
              cutting.map(made -> List.of(bits, made.nerve.kept())).orElse(List.of(bits)));
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
      cutting.ifPresent(this::beginCutting);
    }

    private Cutting newCutting() {
      ProtectedVoxels nerve = ProtectedVoxels.next(random, scene);
      return new Cutting(nerve, new PlainCopy(scene.bits(), nerve.near()));
    }

    private void beginCutting(Cutting made) {
      Vec3 spacing = scene.spacingMm();
      double rate = random.nextDouble(MOST_VOXELS_RATE) * spacing.x * spacing.y * spacing.z;
      double leastNewton = random.nextInt(3) == 0 ? random.nextDouble() : 0;
      frame.carve(new CarveSettings(rate, List.of(leastNewton), made.nerve.kept()));
      frame.voxels().listen(made.copy);
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
      return device.lastForce().length() == 0 ? faultOfVoxels() : "the last force is not zero";
    }

    private String faultOfVoxels() {
      if (cutting.isEmpty()) {
        return null;
      }
      PlainCopy copy = cutting.get().copy;
      changes += copy.changes();
      if (copy.keptChanges() > 0) {
        return "a protected voxel changed";
      }
      return copy.differentBricks(scene.bits()) > 0 ? "bricks differ from a plain copy" : null;
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
      return cutting.map(this::editBesideCuts).orElseGet(this::anyEdit);
    }

    /** Returns an edit that spares protected voxels, as those of a session do. */
    private Edit editBesideCuts(Cutting made) {
      Optional<BitCube> kept = Optional.of(made.nerve.kept());
      BrushLimits limits = new BrushLimits(Optional.empty(), kept, random.nextBoolean());
      return switch (random.nextInt(4)) {
        case 0 -> HistoryEdit.undo();
        case 1 -> HistoryEdit.redo();
        default -> BrushEdit.atTool(0, new BrushPath(), radiusMm(), random.nextInt(3) != 0, limits);
      };
    }

    private Edit anyEdit() {
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
      return new BrushEdit(0, centre, radiusMm(), solid);
    }

    private double radiusMm() {
      return scene.metric().shortestEdgeMm() * (0.3 + 3 * random.nextDouble());
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
        if (touches(path, leg)) {
          return "leg " + leg + " touches a solid";
        }
        at.set(path.end(leg, 0), path.end(leg, 1), path.end(leg, 2));
      }
      boolean ends = at.sameBits(frame.point().position) || (begins && path.count() == 0);
      return ends ? null : "the point is not where its last leg ended";
    }

    private boolean touches(LegPath path, int leg) {
      return judge.touches(collisionScene.cube(0), path, leg)
          || (cutting.isPresent() && judge.touches(cutting.get().nerve.kept(), path, leg));
    }
  }
}
