package org.palpate.host;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * Presents a device in grid coordinates: positions are grid coordinates, forces act along the
 * grid's axes. This is the one place where the haptic thread converts between world and grid.
 *
 * <p>One thread reads and writes; any thread closes. Allocates nothing in a frame.
 */
public final class GridDevice extends DeviceDecorator {
  private final VoxelGrid grid;
  private final Vec3 forceWorldNewton = new Vec3();

  /**
   * Wraps a device.
   *
   * @param device positions in world mm, forces along the world's axes
   * @param grid the grid to convert to
   */
  public GridDevice(HapticDevice device, VoxelGrid grid) {
    super(device);
    this.grid = grid;
  }

  /** Reads the device; the position of {@code state} is in grid coordinates. */
  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(state);
    if (status == ReadStatus.FRESH) {
      grid.worldToGrid(state.positionMm, state.positionMm);
    }
    return status;
  }

  /**
   * Sends a force and a torque.
   *
   * @param forceNewton force on the hand along the grid's axes, N
   * @param torqueNewtonMm torque on the hand along the world's axes, N mm; a point has none
   */
  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    grid.gridMmToWorld().rotate(forceNewton, forceWorldNewton);
    return device.write(forceWorldNewton, torqueNewtonMm);
  }
}
