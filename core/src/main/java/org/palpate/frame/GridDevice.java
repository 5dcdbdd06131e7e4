package org.palpate.frame;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * A device as a {@link PointFrame} takes it: positions are grid coordinates, and forces act along
 * the grid's axes. It is not a {@link HapticDevice}, whose positions are world mm, so the compiler
 * keeps the two apart.
 *
 * <p>{@link #fromWorld} is the one place where the haptic thread converts between world and grid.
 * Threads are those of the device. Allocates nothing in a frame.
 */
public final class GridDevice {
  private final HapticDevice device;

  private GridDevice(HapticDevice device) {
    this.device = device;
  }

  /**
   * {@return a device converted to a grid}
   *
   * @param worldDevice positions in world mm, forces along the world's axes
   * @param grid the grid to convert to
   */
  public static GridDevice fromWorld(HapticDevice worldDevice, VoxelGrid grid) {
    return new GridDevice(new Converted(worldDevice, grid));
  }

  /**
   * {@return a device as it is, because its positions are grid coordinates already; for example a
   * trajectory that was made in the grid}
   *
   * @param device its positions are grid coordinates; the caller closes it
   */
  public static GridDevice inGridCoordinates(HapticDevice device) {
    return new GridDevice(device);
  }

  /** Returns the device that delivers grid coordinates and takes forces along the grid's axes. */
  HapticDevice device() {
    return device;
  }

  /** Converts the positions and forces of a device in the world. */
  private static final class Converted extends DeviceDecorator {
    private final VoxelGrid grid;
    private final Vec3 forceWorldNewton = new Vec3();

    Converted(HapticDevice device, VoxelGrid grid) {
      super(device);
      this.grid = grid;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      ReadStatus status = device.read(state);
      if (status == ReadStatus.FRESH) {
        grid.worldToGrid(state.positionMm, state.positionMm);
      }
      return status;
    }

    /** Sends a force along the grid's axes; the torque stays, because a point has none. */
    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      grid.gridMmToWorld().rotate(forceNewton, forceWorldNewton);
      return device.write(forceWorldNewton, torqueNewtonMm);
    }
  }
}
