package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalDouble;
import org.palpate.collision.CollisionScene;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A hand that a test moves, a frame, and synchronous updates: an elastic replay in small. */
final class ElasticTouch {
  final Vec3 hand = new Vec3();
  final BitCube soft;
  final BitCube still;
  final CollisionScene scene;
  final ControlLattice lattice;
  final ElasticBody body;
  final EditQueue edits;
  final ScriptedDevice device;
  final PointFrame frame;
  final ProxySolver solver;
  final double newtonPerMm;
  final SynchronousUpdates updates;
  private long millis;

  /** Makes a scene at rest without friction, with the hand and the point at a free place. */
  ElasticTouch(Scene made, double young, double newtonPerMm, double edgeMm, boolean smooth) {
    this(made, young, ForceSettings.of(newtonPerMm, 0), edgeMm, smooth);
  }

  /** Makes a scene at rest with other forces. */
  ElasticTouch(Scene made, double young, ForceSettings force, double edgeMm, boolean smooth) {
    this(made, young, force, edgeMm, OptionalDouble.empty(), smooth);
  }

  /** Makes a scene at rest with a contact of any radius. */
  ElasticTouch(
      Scene made,
      double young,
      ForceSettings force,
      double edgeMm,
      OptionalDouble radiusMm,
      boolean smooth) {
    newtonPerMm = force.stiffnessNewtonPerMm();
    soft = made.soft;
    still = made.still;
    GridMetric metric = made.metric;
    scene = new CollisionScene(List.of(soft, still));
    lattice =
        new ControlLattice(
            metric,
            List.of(new ElasticSegment(soft, new ElasticMaterial(young, 0.4))),
            List.of(still),
            edgeMm,
            radiusMm);
    body = new ElasticBody(lattice, metric);
    updates = new SynchronousUpdates(body);
    Vec3 spacing = new Vec3(metric.spacingX(), metric.spacingY(), metric.spacingZ());
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(soft.sizeX(), soft.sizeY(), soft.sizeZ());
    edits = new EditQueue(grid, 2);
    device =
        new ScriptedDevice(
            (read, state) -> {
              state.positionMm.set(hand);
              state.timeNanos = 1_000_000L * read;
              return ReadStatus.FRESH;
            });
    double wMax = 8 * Math.min(spacing.x, Math.min(spacing.y, spacing.z));
    solver = smooth ? new SmoothSolver(metric, wMax) : new GuardedSolver(metric, wMax);
    frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            solver,
            scene,
            metric,
            new FrameSettings(
                force,
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                0,
                FrameSettings.NO_SILENCE,
                Integer.MAX_VALUE),
            edits,
            (d, p, newton, contact, number) -> {});
    frame.deform(body.contact());
  }

  /** Voxels of a soft segment and of one that stands still. */
  record Scene(BitCube soft, BitCube still, GridMetric metric) {
    /** A block of 64x64x40 voxels on a floor, with air around. */
    static Scene block(GridMetric metric) {
      BitCube soft = new BitCube(96, 96, 72);
      BitCube still = new BitCube(96, 96, 72);
      fill(soft, 16, 80, 16, 80, 8, 48);
      fill(still, 8, 88, 8, 88, 4, 8);
      return new Scene(soft, still, metric);
    }
  }

  /**
   * Fills all voxels of a cube except for a rim, and returns the lattice of what is filled.
   *
   * @param rim the number of empty voxels on each side
   * @param edgeMm the edge of a cell of the lattice
   */
  static ControlLattice softCube(BitCube bits, int rim, GridMetric metric, double edgeMm) {
    int end = bits.sizeX() - rim;
    fill(bits, rim, end, rim, end, rim, end);
    ElasticSegment soft = new ElasticSegment(bits, new ElasticMaterial(1e4, 0.3));
    return new ControlLattice(metric, List.of(soft), List.of(), edgeMm);
  }

  /** Asserts that the inverse of a map, begun near a material point, undoes the map at another. */
  static void assertInverseUndoes(DeformationMap map, Vec3 material, Vec3 near) {
    Vec3 present = map.forward(material, new Vec3());
    Vec3 back = new Vec3().set(near);
    map.inverse(present, back, back);
    Vec3 again = map.forward(back, new Vec3());
    assertEquals(0, again.sub(present, again).length(), 1e-9, "present");
    assertEquals(0, back.sub(material, back).length(), 1e-8, "material");
  }

  static void fill(BitCube bits, int x0, int x1, int y0, int y1, int z0, int z1) {
    for (int k = z0; k < z1; k++) {
      for (int j = y0; j < y1; j++) {
        for (int i = x0; i < x1; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  /** Runs one frame at the present hand, 1 ms after the last. */
  void run() {
    updates.beforeFrame();
    runWithoutUpdate();
  }

  /** Runs one frame as if the thread of the updates had died. */
  void runWithoutUpdate() {
    frame.run(1_000_000L * millis++);
    device.forces.clear();
    device.torques.clear();
  }

  /** Moves the hand along a straight line in so many frames. */
  void moveTo(double x, double y, double z, int frames) {
    Vec3 from = new Vec3().set(hand);
    for (int n = 1; n <= frames; n++) {
      double t = (double) n / frames;
      hand.set(from.x + t * (x - from.x), from.y + t * (y - from.y), from.z + t * (z - from.z));
      run();
    }
  }
}
