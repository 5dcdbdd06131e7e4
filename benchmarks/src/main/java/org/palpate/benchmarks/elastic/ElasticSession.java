package org.palpate.benchmarks.elastic;

import java.util.List;
import java.util.OptionalDouble;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.EditQueue;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticBodyVariants;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.VoxelGrid;

/**
 * A hand that presses a soft scene: frames of 1 ms, and updates between them as in a replay. One
 * thread.
 */
final class ElasticSession {
  private static final double POISSON = 0.4;
  private static final double STEP_VOXELS = 8;
  private static final long FRAME_NANOS = 1_000_000;

  private final MovedHand device = new MovedHand();
  private final ElasticBody body;
  private final SynchronousUpdates updates;
  private final EditQueue edits;
  private final PointFrame frame;
  private int frames;

  /** Creates a session without a window, however small the radius of the contact is. */
  ElasticSession(SoftScene scene, Softness softness) {
    this(scene, softness, false);
  }

  /**
   * Creates a session.
   *
   * @param windowed whether a window follows the contact if its radius is less than two cells
   */
  ElasticSession(SoftScene scene, Softness softness, boolean windowed) {
    GridMetric metric = scene.metric();
    ElasticMaterial material = new ElasticMaterial(softness.youngPascal(), POISSON);
    ControlLattice lattice =
        new ControlLattice(
            metric,
            List.of(new ElasticSegment(scene.soft(), material)),
            List.of(scene.still()),
            softness.cellMm(),
            windowed ? OptionalDouble.of(softness.radiusMm()) : OptionalDouble.empty());
    body = ElasticBodyVariants.body(lattice, metric, softness.radiusMm(), softness.residual());
    updates = new SynchronousUpdates(body);
    edits =
        new EditQueue(
            VoxelGrid.ofUnitVoxels(
                scene.soft().sizeX(), scene.soft().sizeY(), scene.soft().sizeZ()),
            scene.solids().size());
    double step = STEP_VOXELS * metric.shortestEdgeMm();
    ProxySolver solver =
        softness.smooth() ? new SmoothSolver(metric, step) : new GuardedSolver(metric, step);
    frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            solver,
            new CollisionScene(scene.solids()),
            metric,
            new FrameSettings(
                ForceSettings.of(softness.newtonPerMm(), 0),
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                0,
                FrameSettings.NO_SILENCE,
                Integer.MAX_VALUE),
            edits,
            (hand, point, newton, contact, number) -> {});
    frame.deform(body.contact());
  }

  /** Returns the position of the hand, grid coordinates, to change between frames. */
  Vec3 hand() {
    return device.position;
  }

  /** Updates the body if a period is over, and runs a frame. */
  void run() {
    update();
    runFrame();
  }

  /** Updates the body if a period is over. Call it before each frame. */
  void update() {
    updates.beforeFrame();
  }

  /** Runs a frame alone. */
  void runFrame() {
    frame.run(FRAME_NANOS * frames);
    frames++;
  }

  /** Whether an update comes before the next frame. */
  boolean updatesNext() {
    return frames > 0 && frames % SynchronousUpdates.FRAMES == 0;
  }

  /** Whether an update came before the last frame. */
  boolean wasUpdated() {
    return frames > 1 && (frames - 1) % SynchronousUpdates.FRAMES == 0;
  }

  /** Moves the hand along a straight line in so many frames, and calls a watcher after each. */
  void moveTo(double x, double y, double z, int count, Runnable afterFrame) {
    Vec3 hand = hand();
    Vec3 from = new Vec3().set(hand);
    for (int n = 1; n <= count; n++) {
      double t = (double) n / count;
      hand.set(from.x + t * (x - from.x), from.y + t * (y - from.y), from.z + t * (z - from.z));
      run();
      afterFrame.run();
    }
  }

  /** Moves the hand along a straight line in so many frames. */
  void moveTo(double x, double y, double z, int count) {
    moveTo(x, y, z, count, () -> {});
  }

  ElasticBody body() {
    return body;
  }

  EditQueue edits() {
    return edits;
  }

  InteractionPoint point() {
    return frame.point();
  }

  /** Whether the last frame began a new chain of legs. */
  boolean wasFreed() {
    return frame.wasFreed();
  }

  /** Returns the force on the hand, N. It belongs to the session. */
  Vec3 forceNewton() {
    return frame.forceNewton();
  }

  /** Returns the present position of the point, grid coordinates. It belongs to the session. */
  Vec3 present() {
    return frame.presentPosition();
  }
}
