package org.palpate.benchmarks.jitter;

import java.util.List;
import org.palpate.device.HandTarget;
import org.palpate.device.SimulatedDevice;
import org.palpate.force.ForceSettings;
import org.palpate.host.ContactSettings;
import org.palpate.host.GridDevice;
import org.palpate.host.HandTargets;
import org.palpate.interaction.EditQueue;
import org.palpate.interaction.FrameOutcome;
import org.palpate.interaction.FramePublisher;
import org.palpate.interaction.FrameSettings;
import org.palpate.interaction.HapticFrame;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** The haptic frame of a session: the simulated hand touches a volume with the smooth solver. */
final class HapticCellFrame implements CellFrame {
  private static final long SEED = 1;

  private final HapticFrame frame;

  /** A frame over all segments together. */
  HapticCellFrame(SegmentedVolume volume) {
    VoxelGrid grid = volume.grid();
    Metric metric = Metric.of(grid.spacingMm());
    HandTarget target = HandTargets.of(volume);
    GridDevice device =
        new GridDevice(new SimulatedDevice(SEED, target, CellRunner.PERIOD_NANOS), grid);
    List<BitCube> cubes = volume.segments().stream().map(Segment::bits).toList();
    frame =
        new HapticFrame(
            device,
            new SmoothSolver(metric, ContactSettings.defaultMaxStepMm(grid.spacingMm())),
            new Obstacles(cubes),
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
      throw new IllegalStateException("the simulated device is gone");
    }
  }
}
