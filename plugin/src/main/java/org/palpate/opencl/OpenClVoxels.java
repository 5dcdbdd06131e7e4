package org.palpate.opencl;

import java.nio.ByteBuffer;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.collision.LegBatch;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/**
 * Voxels that stay on an OpenCL device. The host keeps a copy, so that only bricks that differ are
 * sent. If more than {@link #MOST_CHANGES} differ, all bricks are sent.
 */
final class OpenClVoxels implements DeviceVoxels {
  /** The largest number of bricks that are sent one by one; more take longer than all together. */
  static final int MOST_CHANGES = 16_384;

  private final OpenClDevice device;
  private final ClDriver driver;
  private final BitCube bits;
  private final ClMemory bricks;
  private final ClMemory changes;
  private final long changeKernel;
  private int pending;
  private boolean areAllPending;

  OpenClVoxels(OpenClDevice device, ClDriver driver, BitCube bits) {
    this.device = device;
    this.driver = driver;
    this.bits = bits;
    bricks = driver.allocate(8L * bits.bricksX() * bits.bricksY() * bits.bricksZ());
    changes = driver.allocate(8 * (1 + 2L * MOST_CHANGES));
    changeKernel = driver.kernel("change", bricks, changes);
    for (int z = 0; z < bits.bricksZ(); z++) {
      for (int y = 0; y < bits.bricksY(); y++) {
        for (int x = 0; x < bits.bricksX(); x++) {
          bricks.host().putLong(8 * index(x, y, z), bits.brick(x, y, z));
        }
      }
    }
    areAllPending = true;
  }

  private int index(int x, int y, int z) {
    return (z * bits.bricksY() + y) * bits.bricksX() + x;
  }

  BitCube bits() {
    return bits;
  }

  ClMemory bricks() {
    return bricks;
  }

  @Override
  public void voxelsChanged(IntBox box) {
    int highX = Math.min(bits.sizeX() - 1, box.highX) >> BitCube.BRICK_SHIFT;
    int highY = Math.min(bits.sizeY() - 1, box.highY) >> BitCube.BRICK_SHIFT;
    int highZ = Math.min(bits.sizeZ() - 1, box.highZ) >> BitCube.BRICK_SHIFT;
    for (int z = Math.max(0, box.lowZ) >> BitCube.BRICK_SHIFT; z <= highZ; z++) {
      for (int y = Math.max(0, box.lowY) >> BitCube.BRICK_SHIFT; y <= highY; y++) {
        for (int x = Math.max(0, box.lowX) >> BitCube.BRICK_SHIFT; x <= highX; x++) {
          compare(index(x, y, z), bits.brick(x, y, z));
        }
      }
    }
  }

  private void compare(int index, long word) {
    if (bricks.host().getLong(8 * index) == word) {
      return;
    }
    bricks.host().putLong(8 * index, word);
    if (pending == MOST_CHANGES) {
      areAllPending = true;
      return;
    }
    ByteBuffer pairs = changes.host();
    pairs.putLong(16 * pending + 8, index);
    pairs.putLong(16 * pending + 16, word);
    pending++;
  }

  /** Begins to send the bricks that have changed. */
  void send() {
    if (areAllPending) {
      driver.write(bricks, 8 * index(0, 0, bits.bricksZ()));
    } else if (pending > 0) {
      changes.host().putLong(0, pending);
      driver.write(changes, 8 + 16 * pending);
      driver.launch(changeKernel, pending);
    }
    areAllPending = false;
    pending = 0;
  }

  @Override
  public LegBatch newBatch(PointSet points) {
    return device
        .<LegBatch>attempt(
            () -> device.chosen(new OpenClLegs(device, driver, this, points), points))
        .orElseGet(() -> CollisionDevice.CPU.keep(bits).newBatch(points));
  }
}
