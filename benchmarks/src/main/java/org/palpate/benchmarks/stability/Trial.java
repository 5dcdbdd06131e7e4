package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.edit.EditQueue;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop with an interaction point.
 *
 * @param device the device
 * @param grip the person
 * @param sampling rate and delay
 * @param shape the shape that is pressed
 * @param solver the factory of the solver and its name
 * @param limited whether the force passes the limits of a live session (maximum and slew rate)
 */
public record Trial(
    DeviceModel device,
    Grip grip,
    Sampling sampling,
    TouchedShape shape,
    SolverChoice solver,
    boolean limited)
    implements LoopTrial {

  /** The factory of a solver with its name. */
  public record SolverChoice(String name, Factory factory) {
    /** Makes a solver. */
    @FunctionalInterface
    public interface Factory {
      /** Creates a solver for a metric and w_max, mm. */
      ProxySolver make(GridMetric metric, double maxStepMm);
    }
  }

  @Override
  public List<Object> conditionCells() {
    return List.of(shape.name(), solver.name());
  }

  @Override
  public Outcome run(double newtonPerM) {
    double voxel = TouchedShape.VOXEL_MM;
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, shape.touchMm(), shape.inward());
    Plant plant = loop.plant(voxel);
    GridMetric metric = new GridMetric(voxel, voxel, voxel);
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(plant),
            solver.factory().make(metric, 8 * voxel),
            shape.scene(),
            metric,
            ClosedLoop.settings(plant.specification(), newtonPerM, limited),
            new EditQueue(VoxelGrid.ofUnitVoxels(1, 1, 1), 1),
            FramePublisher.NONE);
    return loop.run(plant, frame);
  }
}
