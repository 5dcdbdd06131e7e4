package org.palpate.benchmarks.carve;

import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.ToolCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.VoxelListener;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.Pose;
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
 * A slab of voxels of 0.25 mm, and a burr of 6 mm diameter and about 1,000 points that moves
 * through it at 60 mm/s, pressed 2 mm deep. One thread.
 */
final class DrilledSlab {
  static final String NAME = "burr of 6 mm in voxels of 0.25 mm";

  private static final double EDGE_MM = 0.25;
  private static final int SIZE = 160;
  private static final int HEIGHT = 64;
  private static final double RADIUS_MM = 3;

  /** The cover radius that gives the burr about 1,000 points, mm. */
  private static final double COVER_MM = 0.257;

  private static final double MM_PER_FRAME = 0.06;
  private static final double DEPTH_MM = 2;
  private static final double SURFACE_MM = HEIGHT / 2 * EDGE_MM;
  private static final double NEWTON_PER_MM = 0.5;
  private static final double RATE = 40;
  private static final long FRAME_NANOS = 1_000_000;

  private final BitCube bits = new BitCube(SIZE, SIZE, HEIGHT);
  private final RigidSolver solver;
  private final VoxelWriter writer;
  private final ToolCarver carver;
  private final ToolMotion motion;
  private final Pose device = new Pose();
  private final Vec3 stretch = new Vec3();
  private double way;
  private int frame;

  /** Makes a whole slab, with the burr above it. */
  DrilledSlab() {
    for (int k = 0; k < HEIGHT / 2; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          bits.set(i, j, k);
        }
      }
    }
    Body body = new Body("bone", bits, grid(), Mobility.FIXED);
    BodyScene bodies = new BodyScene(List.of(body));
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(RADIUS_MM), COVER_MM);
    solver = new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(2, bodies, tool));
    writer =
        new VoxelWriter(
            new CollisionScene(List.of(bits)), (segment, box) -> body.voxelsChanged(box));
    carver = new ToolCarver(CarveSettings.ofRate(RATE), bodies, solver.newBlockingVoxels(), writer);
    motion = solver.newMotion();
    device.translation.set(8, 8, SURFACE_MM + RADIUS_MM + 1);
    solver.place(device, motion);
  }

  static VoxelGrid grid() {
    RigidTransform axes =
        new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
    return new VoxelGrid(SIZE, SIZE, HEIGHT, new Vec3(EDGE_MM, EDGE_MM, EDGE_MM), axes);
  }

  /** Returns the voxels. */
  BitCube bits() {
    return bits;
  }

  /** Sets the receiver of each removed voxel, before the first frame. */
  void listen(VoxelListener listener) {
    writer.listen(listener);
  }

  /** Returns the number of removed voxels. */
  long removed() {
    return (long) SIZE * SIZE * (HEIGHT / 2) - bits.solidCount();
  }

  /** Moves the hand, cuts, and moves the burr after it. */
  void runFrame() {
    moveHand();
    cut();
    follow();
  }

  /** Moves the hand to and fro. */
  void moveHand() {
    way += MM_PER_FRAME;
    double x = 8 + Math.abs(way % 48 - 24);
    double y = 8 + Math.min(24, frame++ * 0.002);
    device.translation.set(x, y, SURFACE_MM + RADIUS_MM - DEPTH_MM);
  }

  /** Cuts with the force of the present pose. */
  void cut() {
    double pulledMm = motion.pose().translation.sub(device.translation, stretch).length();
    carver.carve(device, NEWTON_PER_MM * pulledMm, FRAME_NANOS);
  }

  /** Moves the burr after the hand. */
  void follow() {
    solver.follow(device, motion);
  }
}
