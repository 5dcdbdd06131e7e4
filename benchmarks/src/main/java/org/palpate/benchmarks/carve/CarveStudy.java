package org.palpate.benchmarks.carve;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidLegJudge;
import org.palpate.benchmarks.stress.HostileScene;
import org.palpate.benchmarks.stress.PlainCopy;
import org.palpate.benchmarks.stress.ProtectedVoxels;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.BrushLimits;
import org.palpate.edit.BrushPath;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Attacks frames of tools that cut: hostile hands, cuts, brushes that follow the tool, undo and
 * redo, beside a protected segment. Every leg of the tool is judged exactly. At the end of each
 * round the voxels are compared with a plain copy that a listener changed. Then all strokes are
 * undone and redone.
 */
final class CarveStudy {
  private static final int FRAMES_PER_ROUND = 1_000;
  private static final int EDIT_VOXELS = 2_048;
  private static final long FRAME_NANOS = 1_000_000;

  /** The force by which the hand pulls at a tool that is one voxel edge behind, N. */
  private static final double NEWTON_PER_EDGE = 2;

  /** The highest rate of cutting, voxels per N s. */
  private static final double MOST_VOXELS_RATE = 1e4;

  private static final double FRICTION = 0.3;
  private static final int REPORTS = 20;

  private static final DeviceSpecification DEVICE =
      new DeviceSpecification("hostile", "", 8, 1, 100, 0, true, 200);

  /** The tools of an attack. */
  enum Tools {
    /** Their sample points cover them within a voxel. */
    FEW_POINTS("tools of some 50 points"),
    /** As many points as the burr of {@link DrilledSlab} has. */
    MANY_POINTS("tools of some 1,000 points");

    /** A tool has its area divided by this and the squared cover radius as its points. */
    private static final double AREA_PER_POINT = 1.7;

    private static final double MANY = 1_000;
    private final String condition;

    Tools(String condition) {
      this.condition = condition;
    }

    private RigidTool next(SplittableRandom random, double edgeMm) {
      double radiusMm = 2 * edgeMm;
      double lengthMm = random.nextDouble(5) * edgeMm;
      double areaMm2 = 2 * Math.PI * radiusMm * (2 * radiusMm + lengthMm);
      double coverMm = this == FEW_POINTS ? edgeMm : Math.sqrt(areaMm2 / (AREA_PER_POINT * MANY));
      return ToolSampler.ofShape(RodShape.capsule(radiusMm, lengthMm), coverMm);
    }
  }

  private final Tools tools;
  private final SplittableRandom random;
  private final Consumer<String> progress;
  private final RigidLegJudge judge = new RigidLegJudge(100_000);
  private long frames;
  private long points;
  private long changes;
  private long freed;
  private long different;
  private long keptChanges;
  private long marginFrames;
  private long nearer;
  private long strokes;
  private long statesThatDiffer;

  CarveStudy(Tools tools, long seed, Consumer<String> progress) {
    this.tools = tools;
    random = new SplittableRandom(seed);
    this.progress = progress;
  }

  /** Runs the attack for at least a number of frames, and returns its figures. */
  List<RigidFigure> figures(long wanted) {
    long reported = 0;
    while (frames < wanted) {
      new Round().run();
      if (frames - reported >= wanted / REPORTS) {
        reported = frames;
        progress.accept(line());
      }
    }
    return List.of(
        noneOf("legs that touch a solid", judge.touching()),
        noneOf("broken chains", judge.broken()),
        noneOf("bricks that differ from a plain copy", different),
        noneOf("states that undo and redo do not restore", statesThatDiffer),
        noneOf("changes of protected voxels", keptChanges),
        noneOf("frames nearer to a protected segment than its margin", nearer),
        countOf("frames judged for the margin", marginFrames),
        countOf("legs judged", judge.legs()),
        countOf("frames", frames),
        countOf("points of a tool, mean", points * FRAMES_PER_ROUND / frames),
        countOf("voxels removed or filled", changes),
        countOf("tools set free", freed),
        countOf("strokes undone and redone", strokes));
  }

  private String line() {
    long faults =
        judge.touching() + judge.broken() + different + statesThatDiffer + keptChanges + nearer;
    return tools.condition + ": " + frames + " frames, " + judge.legs() + " legs, faults " + faults;
  }

  private RigidFigure noneOf(String name, long count) {
    return new RigidFigure("attack", tools.condition, name, (double) count, "", 0);
  }

  private RigidFigure countOf(String name, long count) {
    return RigidFigure.of("attack", tools.condition, name, (double) count, "");
  }

  private Vec3 vector(double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** The hand: it moves a little, pushes, or jumps anywhere. */
  private final class Hand implements HapticDevice {
    private final double edgeMm;
    private final Pose pose = new Pose();
    private final Quaternion scratch = new Quaternion();
    private long nanos;

    Hand(double edgeMm) {
      this.edgeMm = edgeMm;
      jump(25);
    }

    private void jump(double edges) {
      pose.translation.set(vector(edges * edgeMm));
      pose.rotation.setRotationVector(vector(2));
    }

    private void move(Pose tool) {
      if (random.nextInt(100) == 0) {
        jump(12);
      } else if (random.nextInt(3) == 0) {
        pose.set(tool);
        pose.displace(vector(3 * edgeMm), vector(0.2), 1, scratch, pose);
      } else {
        pose.displace(vector(0.3 * edgeMm), vector(0.05), 1, scratch, pose);
      }
    }

    @Override
    public DeviceSpecification specification() {
      return DEVICE;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      nanos += FRAME_NANOS;
      state.positionMm.set(pose.translation);
      state.orientation.set(pose.rotation);
      state.timeNanos = nanos;
      return ReadStatus.FRESH;
    }

    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      return true;
    }

    @Override
    public void close() {}
  }

  /** One scene with its tool. */
  private final class Round {
    private final HostileScene scene = HostileScene.next(random);
    private final ProtectedVoxels nerve = ProtectedVoxels.next(random, scene);
    private final BitCube bits = scene.bits();
    private final BitCube start = bits.copy();
    private final PlainCopy copy = new PlainCopy(bits, nerve.near());
    private final BodyScene bodies;
    private final RigidTool tool;
    private final Hand hand;
    private final EditQueue queue;
    private final ToolFrame frame;
    private final AffineMap toGrid = new AffineMap();
    private final Vec3 point = new Vec3();

    Round() {
      VoxelGrid grid = gridOf(scene);
      bodies =
          new BodyScene(
              List.of(
                  new Body("solid", bits, grid, Mobility.FIXED),
                  new Body("nerve", nerve.nerve(), grid, Mobility.FIXED)));
      double edgeMm = bodies.shortestEdgeMm();
      tool = tools.next(random, edgeMm);
      hand = new Hand(edgeMm);
      queue = EditQueue.ofBodies(bodies.grids());
      double newtonPerMm = NEWTON_PER_EDGE / edgeMm;
      frame =
          new ToolFrame(
              hand,
              bodies,
              new RigidSolver(bodies, tool, settings(grid)),
              RigidCoupling.of(tool, newtonPerMm),
              FrameSettings.live(DEVICE, ForceSettings.of(newtonPerMm, FRICTION)),
              queue,
              ToolFramePublisher.NONE);
      Vec3 spacing = scene.spacingMm();
      double rate = random.nextDouble(MOST_VOXELS_RATE) * spacing.x * spacing.y * spacing.z;
      frame.carve(new CarveSettings(rate, List.of(), nerve.kept()));
      frame.voxels().listen(copy);
    }

    /** Returns whole-tool clearances, from the protected segment with its margin. */
    private RigidSettings settings(VoxelGrid grid) {
      return new RigidSettings(
          scene.maxStepMm(),
          List.of(
              Clearance.ofWholeBody(tool, grid, 0),
              Clearance.ofWholeBody(tool, grid, nerve.marginMm())),
          List.of(),
          true);
    }

    private static VoxelGrid gridOf(HostileScene scene) {
      BitCube bits = scene.bits();
      Vec3 spacing = scene.spacingMm();
      Vec3 corner =
          new Vec3(
              -bits.sizeX() * spacing.x / 2,
              -bits.sizeY() * spacing.y / 2,
              -bits.sizeZ() * spacing.z / 2);
      RigidTransform axes =
          new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), corner);
      return new VoxelGrid(bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, axes);
    }

    void run() {
      for (int n = 0; n < FRAMES_PER_ROUND; n++) {
        if (random.nextInt(10) == 0) {
          queue.offer(edit());
        }
        hand.move(frame.motion().pose());
        frame.run(n * FRAME_NANOS);
        if (n == 0 || frame.wasFreed()) {
          judge.begin(frame.motion().pathPose(0));
        }
        judge.judge(bodies, tool, frame.motion());
        freed += frame.wasFreed() ? 1 : 0;
        judgeMargin();
      }
      frames += FRAMES_PER_ROUND;
      points += tool.count();
      applyAll();
      different += copy.differentBricks(bits);
      keptChanges += copy.keptChanges();
      changes += copy.changes();
      undoAndRedo();
    }

    private Edit edit() {
      int kind = random.nextInt(6);
      if (kind < 2) {
        return kind == 0 ? HistoryEdit.undo() : HistoryEdit.redo();
      }
      double radiusMm = random.nextDouble(3) * bodies.shortestEdgeMm();
      BrushLimits limits =
          new BrushLimits(Optional.empty(), Optional.of(nerve.kept()), random.nextBoolean());
      return BrushEdit.atTool(0, new BrushPath(), radiusMm, random.nextBoolean(), limits);
    }

    /** Points that start nearer than the clearance keep their distance, and are not judged. */
    private void judgeMargin() {
      if (frame.motion().reducedPoints() == 0) {
        marginFrames++;
        nearer += isTooNear() ? 1 : 0;
      }
    }

    private boolean isTooNear() {
      bodies.body(1).toolToGrid(frame.motion().pose(), toGrid);
      for (int n = 0; n < tool.count(); n++) {
        toGrid.transform(tool.point(n, point), point);
        if (nerve.isNear(point.x, point.y, point.z)) {
          return true;
        }
      }
      return false;
    }

    private void applyAll() {
      while (!queue.isIdle()) {
        queue.applyTo(frame.voxels(), EDIT_VOXELS);
      }
    }

    private void undoAndRedo() {
      BitCube end = bits.copy();
      int undoable = frame.voxels().history().undoable();
      for (int n = 0; n < undoable; n++) {
        queue.offer(HistoryEdit.undo());
        applyAll();
      }
      boolean isStart = PlainCopy.differentBricks(bits, start) == 0;
      for (int n = 0; n < undoable; n++) {
        queue.offer(HistoryEdit.redo());
        applyAll();
      }
      boolean isEnd = PlainCopy.differentBricks(bits, end) == 0;
      strokes += undoable;
      statesThatDiffer += (isStart ? 0 : 1) + (isEnd ? 0 : 1);
    }
  }
}
