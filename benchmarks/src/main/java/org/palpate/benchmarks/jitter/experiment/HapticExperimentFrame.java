package org.palpate.benchmarks.jitter.experiment;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.host.ContactSettings;
import org.palpate.host.HandTargetFinder;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** The haptic frame of a session: a simulated hand touches a volume with the smooth solver. */
final class HapticExperimentFrame implements ExperimentFrame {
  private static final long SEED = 1;

  private final PointFrame frame;

  /**
   * Creates a frame over all segments of a volume.
   *
   * @param periodNanos the time between two samples of the hand
   */
  HapticExperimentFrame(SegmentedVolume volume, long periodNanos) {
    VoxelGrid grid = volume.grid();
    GridMetric metric = GridMetric.of(grid.spacingMm());
    HandTarget target = HandTargetFinder.of(volume);
    HapticDevice device = new SimulatedDevice(SEED, target, periodNanos);
    List<BitCube> cubes = volume.segments().stream().map(Segment::bits).toList();
    frame =
        new PointFrame(
            GridDevice.fromWorld(device, grid),
            new SmoothSolver(metric, ContactSettings.defaultMaxStepMm(grid.spacingMm())),
            new CollisionScene(cubes),
            metric,
            FrameSettings.live(
                device.specification(),
                ForceSettings.of(
                    ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM, ForceSettings.DEFAULT_FRICTION)),
            new EditQueue(grid, cubes.size()),
            FramePublisher.NONE);
  }

  @Override
  public void run() {
    if (frame.run(System.nanoTime()) != FrameOutcome.RUNNING) {
      throw new IllegalStateException("the simulated device is disconnected");
    }
  }
}
