package org.palpate.testing;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HapticDevice;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** A grid of 32^3 unit voxels that are solid below z = 8, with frames over it. */
public final class Floor {
  /** Voxels along each axis. */
  public static final int EDGE = 32;

  /** Height of the surface. */
  public static final int TOP = 8;

  static final double STIFFNESS = 0.5;
  public static final GridMetric METRIC = new GridMetric(1, 1, 1);
  public static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);

  public final BitCube bits = bits();
  public final CollisionScene scene = new CollisionScene(List.of(bits));
  public final EditQueue edits = new EditQueue(GRID, 1);

  private Floor() {}

  /** Makes a floor of its own. */
  public static Floor make() {
    return new Floor();
  }

  /** Returns a new bit cube of the floor. */
  public static BitCube bits() {
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

  /** Returns settings without limits, with a silence of 20 ms and a ramp of 100 ms. */
  public static FrameSettings settings() {
    return new FrameSettings(
        ForceSettings.of(STIFFNESS, 0.2),
        Double.POSITIVE_INFINITY,
        Double.POSITIVE_INFINITY,
        100 * ManualClock.MS,
        20 * ManualClock.MS,
        64);
  }

  /** Returns a frame with the usual settings and the solver {@code guarded}. */
  public PointFrame frame(HapticDevice device) {
    return frame(device, settings());
  }

  /** Returns a frame with the solver {@code guarded}. */
  public PointFrame frame(HapticDevice device, FrameSettings settings) {
    return new PointFrame(
        GridDevice.inGridCoordinates(device),
        new GuardedSolver(METRIC, 8),
        scene,
        METRIC,
        settings,
        edits,
        FramePublisher.NONE);
  }
}
