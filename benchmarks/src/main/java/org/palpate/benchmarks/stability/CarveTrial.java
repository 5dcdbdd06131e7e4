package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.edit.EditQueue;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop with a burr that a person presses into a thick wall, and that cuts.
 * The handle goes into the wall as the burr cuts. A trial counts as stable if the handle never
 * moves back outwards by the edge of a voxel or more.
 *
 * @param device the device
 * @param grip the person
 * @param sampling rate and delay
 * @param rate the volume that a force of 1 N removes in a second, mm^3
 */
public record CarveTrial(DeviceModel device, Grip grip, Sampling sampling, double rate) {
  private static final double VOXEL_MM = TouchedShape.VOXEL_MM;
  private static final double RADIUS_MM = 3;
  private static final double COVER_RADIUS_MM = 0.5;
  private static final int EDGE = 40;
  private static final int HEIGHT = 160;
  private static final int SURFACE = 140;

  /**
   * The result of a trial.
   *
   * @param trial the set-up
   * @param overDefault the stiffness divided by the default one
   * @param outcome its excursion is the longest motion of the handle back out of the wall, in the
   *     last part of the stay
   * @param cutMm3 the volume that was cut in the whole motion
   */
  public record Result(CarveTrial trial, double overDefault, Outcome outcome, double cutMm3) {
    /** Returns the cells of its row in {@code stability-carve.csv}. */
    List<Object> cells() {
      return List.of(
          trial.device.name(),
          trial.grip.name(),
          trial.rate,
          trial.sampling.rateHz(),
          trial.sampling.delaySamples(),
          trial.device.handleKg(),
          trial.device.dampingNewtonSecondPerM(),
          overDefault * MarginRow.defaultNewtonPerM(trial.device),
          overDefault,
          outcome.stable() ? "stable" : "unstable",
          outcome.excursionMm(),
          outcome.energyBackMillijoule(),
          outcome.riseNewtonPerMs(),
          cutMm3);
    }
  }

  /** Runs the trial with the default stiffness times a factor. */
  public Result run(double overDefault) {
    BitCube wall = wall();
    long before = wall.solidCount();
    Outcome outcome = run(overDefault * MarginRow.defaultNewtonPerM(device), wall);
    double cutMm3 = (before - wall.solidCount()) * VOXEL_MM * VOXEL_MM * VOXEL_MM;
    return new Result(this, overDefault, outcome, cutMm3);
  }

  private Outcome run(double newtonPerM, BitCube wall) {
    double middleMm = EDGE / 2 * VOXEL_MM;
    Vec3 touchMm = new Vec3(middleMm, middleMm, SURFACE * VOXEL_MM + RADIUS_MM);
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, touchMm, new Vec3(0, 0, -1));
    Plant plant = loop.plant(1);
    Vec3 spacing = new Vec3(VOXEL_MM, VOXEL_MM, VOXEL_MM);
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, HEIGHT, spacing, RigidTransform.identity());
    BodyScene bodies = new BodyScene(List.of(new Body("wall", wall, grid, Mobility.FIXED)));
    RigidTool burr = ToolSampler.ofShape(RodShape.sphere(RADIUS_MM), COVER_RADIUS_MM);
    ToolFrame frame =
        new ToolFrame(
            plant,
            bodies,
            new RigidSolver(bodies, burr, RigidSettings.ofWholeBodies(8 * VOXEL_MM, bodies, burr)),
            RigidCoupling.of(burr, newtonPerM * 1e-3),
            ClosedLoop.settings(plant.specification(), newtonPerM, true),
            EditQueue.ofBodies(bodies.grids()),
            ToolFramePublisher.NONE);
    frame.carve(CarveSettings.ofRate(rate));
    return loop.runSinking(plant, frame, VOXEL_MM);
  }

  private static BitCube wall() {
    BitCube bits = new BitCube(EDGE, EDGE, HEIGHT);
    for (int n = 0; n < EDGE * EDGE * SURFACE; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    return bits;
  }
}
