package org.palpate.interaction;

import java.util.List;
import org.palpate.force.ForceSettings;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A grid of 32^3 unit voxels of which those below z = 8 are solid, and frames over it. */
final class Floor {
  static final int EDGE = 32;
  static final int TOP = 8;
  static final double STIFFNESS = 0.5;
  static final Metric METRIC = new Metric(1, 1, 1);
  static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);

  final BitCube bits = bits();
  final Obstacles obstacles = new Obstacles(List.of(bits));
  final EditQueue edits = new EditQueue(GRID, 1);

  private Floor() {}

  static Floor make() {
    return new Floor();
  }

  static BitCube bits() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < TOP; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  /** No limits but the silence of 20 ms and a ramp of 100 ms. */
  static FrameSettings settings() {
    return new FrameSettings(
        ForceSettings.of(STIFFNESS, 0.2),
        Double.POSITIVE_INFINITY,
        Double.POSITIVE_INFINITY,
        100 * ManualClock.MS,
        20 * ManualClock.MS,
        64);
  }

  HapticFrame frame(ScriptedDevice device) {
    return frame(device, settings());
  }

  HapticFrame frame(ScriptedDevice device, FrameSettings settings) {
    return new HapticFrame(
        device,
        new GuardedSolver(METRIC, 8),
        obstacles,
        METRIC,
        settings,
        edits,
        FramePublisher.NONE);
  }
}
