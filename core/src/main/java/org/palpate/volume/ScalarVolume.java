package org.palpate.volume;

import java.lang.reflect.Array;

/**
 * Grey values over a grid, each stored as narrowly as the values allow.
 *
 * <p>One thread fills it slice by slice; any thread may read what no one changes. Values are as the
 * file means them (after slope and intercept); their unit is the file's, Hounsfield for CT.
 */
public abstract class ScalarVolume {
  /** How a value is kept; floats hold every whole number up to 2^24 exactly. */
  public enum Storage {
    UINT8(1, 0, 255),
    INT16(2, Short.MIN_VALUE, Short.MAX_VALUE),
    UINT16(2, 0, 65535),
    FLOAT32(4, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    private final int bytes;
    private final double low;
    private final double high;

    Storage(int bytes, double low, double high) {
      this.bytes = bytes;
      this.low = low;
      this.high = high;
    }

    public int bytes() {
      return bytes;
    }

    /** The narrowest storage for whole numbers from {@code low} to {@code high}. */
    public static Storage forWholeNumbers(double low, double high) {
      for (Storage storage : values()) {
        if (low >= storage.low && high <= storage.high) {
          return storage;
        }
      }
      return FLOAT32;
    }
  }

  /** How many voxels {@link #levels} reads. */
  public static final int LEVELS = 8;

  private final VoxelGrid grid;
  private final Storage storage;
  final int sizeX;

  private ScalarVolume(VoxelGrid grid, Storage storage) {
    this.grid = grid;
    this.storage = storage;
    sizeX = grid.sizeX();
  }

  /** A volume of zeros; look at {@link #bytesFor} first. */
  public static ScalarVolume of(VoxelGrid grid, Storage storage) {
    long slice = (long) grid.sizeX() * grid.sizeY();
    if (slice > Integer.MAX_VALUE - 8) {
      throw new IllegalArgumentException(
          "a slice has too many voxels: slice=" + grid.sizeX() + "x" + grid.sizeY());
    }
    int count = grid.sizeZ();
    int size = (int) slice;
    return switch (storage) {
      case UINT8 -> new OfBytes(grid, new byte[count][size]);
      case INT16, UINT16 -> new OfShorts(grid, storage, new short[count][size]);
      case FLOAT32 -> new OfFloats(grid, new float[count][size]);
    };
  }

  /**
   * A volume over slices that someone else keeps and no one changes as long as it is read.
   *
   * @param slices each a {@code byte[]} of 0 to 255, a {@code short[]} of 0 to 65535 or a {@code
   *     float[]}, all of one type, row by row; not copied
   */
  public static ScalarVolume over(VoxelGrid grid, Object[] slices) {
    if (slices.length != grid.sizeZ()) {
      throw new IllegalArgumentException(
          "there must be a slice for each k: slices=" + slices.length + " grid=" + grid.sizeZ());
    }
    if (slices[0] instanceof byte[]) {
      return new OfBytes(grid, checked(grid, slices, new byte[slices.length][]));
    }
    if (slices[0] instanceof short[]) {
      return new OfShorts(grid, Storage.UINT16, checked(grid, slices, new short[slices.length][]));
    }
    return new OfFloats(grid, checked(grid, slices, new float[slices.length][]));
  }

  private static <T> T[] checked(VoxelGrid grid, Object[] slices, T[] typed) {
    int values = grid.sizeX() * grid.sizeY();
    Class<?> type = typed.getClass().getComponentType();
    for (int k = 0; k < slices.length; k++) {
      if (!type.isInstance(slices[k]) || Array.getLength(slices[k]) != values) {
        throw new IllegalArgumentException(
            "a slice must have as many values as the grid, of one type: k="
                + k
                + " values="
                + values);
      }
    }
    System.arraycopy(slices, 0, typed, 0, slices.length);
    return typed;
  }

  /** Bytes that the values of such a volume take; may be far more than there is. */
  public static double bytesFor(VoxelGrid grid, Storage storage) {
    return (double) grid.sizeX() * grid.sizeY() * grid.sizeZ() * storage.bytes();
  }

  public VoxelGrid grid() {
    return grid;
  }

  public Storage storage() {
    return storage;
  }

  /** The value of voxel (i,j,k), which must lie in the grid. */
  public abstract double value(int i, int j, int k);

  /**
   * The levels of {@link #LEVELS} voxels from (i,j,k) on along a row, all in the grid: a byte each,
   * the first in the lowest. For who reads many: several times as fast as {@link #value}.
   */
  public abstract long levels(int i, int j, int k, GreyQuantizer scale);

  /** Stores a value, rounded and held to the storage's range, at voxel (i,j,k) of the grid. */
  public abstract void set(int i, int j, int k, double value);

  final int indexInSlice(int i, int j, int k) {
    assert grid.contains(i, j, k) : "voxel lies outside: voxel=" + i + "," + j + "," + k;
    return j * sizeX + i;
  }

  private int nearestWhole(double value) {
    return (int) Math.rint(Math.max(storage.low, Math.min(storage.high, value)));
  }

  private static final class OfBytes extends ScalarVolume {
    private final byte[][] slices;

    OfBytes(VoxelGrid grid, byte[][] slices) {
      super(grid, Storage.UINT8);
      this.slices = slices;
    }

    @Override
    public double value(int i, int j, int k) {
      return slices[k][indexInSlice(i, j, k)] & 0xff;
    }

    @Override
    public long levels(int i, int j, int k, GreyQuantizer scale) {
      byte[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= (long) scale.ofWhole(slice[from + n] & 0xff) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (byte) super.nearestWhole(value);
    }
  }

  private static final class OfShorts extends ScalarVolume {
    private final short[][] slices;
    private final int mask;

    OfShorts(VoxelGrid grid, Storage storage, short[][] slices) {
      super(grid, storage);
      this.slices = slices;
      mask = storage == Storage.UINT16 ? 0xffff : -1; // all ones keeps the sign
    }

    @Override
    public double value(int i, int j, int k) {
      return slices[k][indexInSlice(i, j, k)] & mask;
    }

    @Override
    public long levels(int i, int j, int k, GreyQuantizer scale) {
      short[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= (long) scale.ofWhole(slice[from + n] & mask) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (short) super.nearestWhole(value);
    }
  }

  private static final class OfFloats extends ScalarVolume {
    private final float[][] slices;

    OfFloats(VoxelGrid grid, float[][] slices) {
      super(grid, Storage.FLOAT32);
      this.slices = slices;
    }

    @Override
    public double value(int i, int j, int k) {
      return slices[k][indexInSlice(i, j, k)];
    }

    @Override
    public long levels(int i, int j, int k, GreyQuantizer scale) {
      float[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= (long) scale.of(slice[from + n]) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (float) value;
    }
  }
}
