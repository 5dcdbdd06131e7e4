package org.palpate.io.format;

import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.VoxelGrid;

/** Checks that memory is free before it is allocated. */
public final class MemoryCheck {
  /** Memory left for everything else that runs while a volume is read. */
  private static final double RESERVE_BYTES = 32e6;

  private MemoryCheck() {}

  /** Returns the bytes that can still be allocated without touching the reserve. */
  static double availableBytes() {
    Runtime runtime = Runtime.getRuntime();
    double used = (double) runtime.totalMemory() - runtime.freeMemory();
    return runtime.maxMemory() - used - RESERVE_BYTES;
  }

  /**
   * Checks that a number of bytes is free.
   *
   * @param purpose what needs the bytes, the subject of the message
   * @throws VolumeFormatException if they are not free, even after a garbage collection
   */
  public static void require(double bytes, String purpose, String place)
      throws VolumeFormatException {
    if (bytes > availableBytes()) {
      // garbage counts as used memory until it is collected
      System.gc();
    }
    if (bytes > availableBytes()) {
      throw new VolumeFormatException(
          purpose
              + " needs "
              + NumberText.bytes(bytes + RESERVE_BYTES)
              + " of memory with a reserve, but "
              + NumberText.bytes(availableBytes() + RESERVE_BYTES)
              + " are free",
          place,
          "give Java more memory (JAVA_TOOL_OPTIONS=-Xmx...), or crop or halve the volume");
    }
  }

  /** Returns a slice for a grid after checking that it fits in memory. */
  public static VoxelSlice slice(VoxelGrid grid, boolean integer, String place)
      throws VolumeFormatException {
    double count = (double) grid.sizeX() * grid.sizeY();
    if (count > Integer.MAX_VALUE - 8) {
      throw new VolumeFormatException(
          "a slice of " + grid.sizeX() + "x" + grid.sizeY() + " voxels is too large",
          place,
          "crop the volume in the tool that wrote it");
    }
    require(count * (integer ? 4 : 8), "one slice", place);
    return new VoxelSlice(grid.sizeX(), grid.sizeY(), integer);
  }
}
