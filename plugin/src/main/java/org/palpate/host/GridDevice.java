package org.palpate.host;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * A device seen from the grid: positions come in grid coordinates, forces go along the grid's axes.
 * The one place where the haptic thread passes between world and grid.
 *
 * <p>Read and written by one thread, closed by any; allocates nothing.
 */
public final class GridDevice extends DeviceDecorator {
  private final VoxelGrid grid;
  private final Vec3 forceWorldNewton = new Vec3();

  /** Stands before {@code device}, whose positions and forces are of the world. */
  public GridDevice(HapticDevice device, VoxelGrid grid) {
    super(device);
    this.grid = grid;
  }

  /** As the device answers; the state's position is in grid coordinates. */
  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(state);
    if (status == ReadStatus.FRESH) {
      grid.worldToGrid(state.positionMm, state.positionMm);
    }
    return status;
  }

  /**
   * Sends a force.
   *
   * @param forceNewton along the grid's axes
   */
  @Override
  public boolean write(Vec3 forceNewton) {
    return device.write(grid.gridMmToWorld().rotate(forceNewton, forceWorldNewton));
  }
}
