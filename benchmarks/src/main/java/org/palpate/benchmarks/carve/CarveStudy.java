package org.palpate.benchmarks.carve;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.benchmarks.rigid.RigidLegJudge;
import org.palpate.benchmarks.stress.HostileScene;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.ToolCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.HistoryEdit;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Attacks tools that cut: hostile hands, cuts, brushes that fill and erase, undo and redo. Every
 * leg of the tool is judged exactly. At the end of each round the voxels are compared with a copy
 * that a listener changed voxel by voxel. Then all strokes are undone and redone.
 */
final class CarveStudy {
  private static final int FRAMES_PER_ROUND = 1_000;
  private static final int EDIT_VOXELS = 2_048;
  private static final long FRAME_NANOS = 1_000_000;
  private static final double FORCE_NEWTON = 2;

  private final SplittableRandom random;
  private final RigidLegJudge judge = new RigidLegJudge(100_000);
  private final Quaternion scratch = new Quaternion();
  private long frames;
  private long removed;
  private long freed;
  private long different;
  private long strokes;
  private long strokesThatDiffer;

  CarveStudy(long seed) {
    random = new SplittableRandom(seed);
  }

  /** Runs the attack for at least a number of frames, and returns its figures. */
  List<RigidFigure> figures(long mostFrames) {
    while (frames < mostFrames) {
      attack();
    }
    return List.of(
        noneOf("legs that touch a solid", judge.touching()),
        noneOf("broken chains", judge.broken()),
        noneOf("bricks that differ from a copy", different),
        noneOf("states that undo and redo do not restore", strokesThatDiffer),
        countOf("legs judged", judge.legs()),
        countOf("frames", frames),
        countOf("voxels removed or filled", removed),
        countOf("tools set free", freed),
        countOf("strokes undone and done again", strokes));
  }

  private static RigidFigure noneOf(String name, long count) {
    return new RigidFigure("attack", "hostile frames", name, (double) count, "", 0);
  }

  private static RigidFigure countOf(String name, long count) {
    return RigidFigure.of("attack", "hostile frames", name, (double) count, "");
  }

  private void attack() {
    HostileScene scene = HostileScene.next(random);
    BitCube bits = scene.bits();
    BitCube copy = bits.copy();
    Body body = new Body("solid", bits, gridOf(scene), Mobility.FIXED);
    BodyScene bodies = new BodyScene(List.of(body));
    double edgeMm = bodies.shortestEdgeMm();
    RigidTool tool =
        ToolSampler.ofShape(RodShape.capsule(2 * edgeMm, random.nextDouble(5) * edgeMm), edgeMm);
    RigidSettings settings = RigidSettings.ofWholeBodies(scene.maxStepMm(), bodies, tool);
    RigidSolver solver = new RigidSolver(bodies, tool, settings);
    VoxelWriter writer =
        new VoxelWriter(
            new CollisionScene(List.of(bits)), (segment, box) -> body.voxelsChanged(box));
    writer.listen((segment, i, j, k, solid) -> change(copy, i, j, k, solid));
    EditQueue queue = EditQueue.ofBodies(bodies.grids());
    ToolCarver carver =
        new ToolCarver(
            CarveSettings.ofRate(random.nextDouble(1e4) * edgeMm * edgeMm * edgeMm),
            bodies,
            solver.newBlockingVoxels(),
            writer);
    ToolMotion motion = solver.newMotion();
    Pose device = pose(25 * edgeMm);
    solver.place(device, motion);
    judge.begin(motion);
    for (int frame = 0; frame < FRAMES_PER_ROUND; frame++) {
      if (random.nextInt(10) == 0) {
        queue.offer(edit(bits));
      }
      queue.applyTo(writer, EDIT_VOXELS);
      move(device, edgeMm, motion);
      carver.carve(device, FORCE_NEWTON, FRAME_NANOS);
      solver.follow(device, motion);
      if (motion.freed()) {
        freed++;
        judge.begin(motion.pathPose(0));
      }
      judge.judge(bodies, tool, motion);
    }
    frames += FRAMES_PER_ROUND;
    different += differentBricks(bits, copy);
    undoAndRedo(writer, queue, bits);
  }

  private void change(BitCube copy, int i, int j, int k, boolean solid) {
    removed++;
    if (solid) {
      copy.set(i, j, k);
    } else {
      copy.clear(i, j, k);
    }
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

  private Pose pose(double reachMm) {
    Pose pose = new Pose();
    pose.translation.set(vector(reachMm));
    pose.rotation.setRotationVector(vector(2));
    return pose;
  }

  private Vec3 vector(double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** Moves the hand: mostly a little, sometimes to anywhere. */
  private void move(Pose device, double edgeMm, ToolMotion motion) {
    if (random.nextInt(100) == 0) {
      device.set(pose(12 * edgeMm));
    } else if (random.nextInt(3) == 0) {
      device.set(motion.pose());
      device.displace(vector(3 * edgeMm), vector(0.2), 1, scratch, device);
    } else {
      device.displace(vector(0.3 * edgeMm), vector(0.05), 1, scratch, device);
    }
  }

  private Edit edit(BitCube bits) {
    int kind = random.nextInt(6);
    if (kind < 2) {
      return kind == 0 ? HistoryEdit.undo() : HistoryEdit.redo();
    }
    Vec3 centre =
        new Vec3(
            random.nextDouble(bits.sizeX()),
            random.nextDouble(bits.sizeY()),
            random.nextDouble(bits.sizeZ()));
    return new BrushEdit(0, centre, random.nextDouble(3), random.nextBoolean());
  }

  /** Counts the bricks of all levels in which two cubes differ. */
  private static long differentBricks(BitCube a, BitCube b) {
    long count = a.solidCount() == b.solidCount() ? 0 : 1;
    for (int z = 0; z < a.bricksZ(); z++) {
      for (int y = 0; y < a.bricksY(); y++) {
        for (int x = 0; x < a.bricksX(); x++) {
          boolean same =
              a.brick(x, y, z) == b.brick(x, y, z)
                  && a.block(x >> 2, y >> 2, z >> 2) == b.block(x >> 2, y >> 2, z >> 2);
          count += same ? 0 : 1;
        }
      }
    }
    return count;
  }

  private void undoAndRedo(VoxelWriter writer, EditQueue queue, BitCube bits) {
    while (!queue.isIdle()) {
      queue.applyTo(writer, EDIT_VOXELS);
    }
    BitCube end = bits.copy();
    int undoable = writer.history().undoable();
    for (int n = 0; n < 2 * undoable; n++) {
      queue.offer(n < undoable ? HistoryEdit.undo() : HistoryEdit.redo());
      while (!queue.isIdle()) {
        queue.applyTo(writer, EDIT_VOXELS);
      }
    }
    strokes += undoable;
    strokesThatDiffer += differentBricks(bits, end) == 0 ? 0 : 1;
  }
}
