package org.palpate.volume;

import java.lang.reflect.Array;

/**
 * Grey values over a grid, in the narrowest storage that the values allow.
 *
 * <p>Values are those of the file after slope and intercept, in the unit of the file: Hounsfield
 * for CT. Thread: one thread fills the volume; any thread may read what no thread changes.
 */
public abstract class ScalarVolume {
  /** The storage of a value. Floats represent every integer up to 2^24 exactly. */
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

    /** {@return the size of a value, bytes} */
    public int bytes() {
      return bytes;
    }

    /**
     * {@return the narrowest storage for integers of a range}
     *
     * @param low the lowest value
     * @param high the highest value, at least {@code low}
     */
    public static Storage forIntegers(double low, double high) {
      for (Storage storage : values()) {
        if (low >= storage.low && high <= storage.high) {
          return storage;
        }
      }
      return FLOAT32;
    }
  }

  /** The number of voxels that {@link #levels} reads. */
  public static final int LEVELS = 8;

  private final VoxelGrid grid;
  private final Storage storage;
  final int sizeX;

  private ScalarVolume(VoxelGrid grid, Storage storage) {
    this.grid = grid;
    this.storage = storage;
    sizeX = grid.sizeX();
  }

  /**
   * {@return a volume of zeros} Allocates {@link #bytesFor} bytes.
   *
   * @param grid the number of voxels along each axis; kept
   * @param storage how values are held
   * @throws IllegalArgumentException if a slice has more voxels than an array can hold
   */
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
   * {@return a volume over the arrays of another program, which nobody may change as long as the
   * volume is read}
   *
   * @param grid as many voxels as the arrays hold; kept
   * @param slices one array a slice, all of one type, row by row: {@code byte[]} of 0 to 255,
   *     {@code short[]} of 0 to 65535 or {@code float[]}; not copied
   * @throws IllegalArgumentException if the slices differ in type or do not fit the grid
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

  /**
   * {@return the memory of the values of a volume, bytes; may be far more than there is}
   *
   * @param grid the number of voxels along each axis
   * @param storage how values would be held
   */
  public static double bytesFor(VoxelGrid grid, Storage storage) {
    return (double) grid.sizeX() * grid.sizeY() * grid.sizeZ() * storage.bytes();
  }

  /** {@return the grid} */
  public VoxelGrid grid() {
    return grid;
  }

  /** {@return the storage of the values} */
  public Storage storage() {
    return storage;
  }

  /**
   * {@return the value of a voxel, in the unit of the file} The voxel must lie in the grid.
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public abstract double value(int i, int j, int k);

  /**
   * {@return the value at a position in grid coordinates, interpolated linearly along each axis
   * between the middles of voxels} Outside the grid the nearest position of it counts.
   *
   * @param x the position along x, grid coordinates, not NaN
   * @param y its y component
   * @param z its z component
   */
  public final double interpolated(double x, double y, double z) {
    double u = Math.max(0, Math.min(grid.sizeX() - 1, x - 0.5));
    double v = Math.max(0, Math.min(grid.sizeY() - 1, y - 0.5));
    double w = Math.max(0, Math.min(grid.sizeZ() - 1, z - 0.5));
    int k = (int) w;
    double low = interpolatedInSlice(u, v, k);
    double fraction = w - k;
    return fraction == 0 ? low : low + fraction * (interpolatedInSlice(u, v, k + 1) - low);
  }

  private double interpolatedInSlice(double u, double v, int k) {
    int j = (int) v;
    double low = interpolatedInRow(u, j, k);
    double fraction = v - j;
    return fraction == 0 ? low : low + fraction * (interpolatedInRow(u, j + 1, k) - low);
  }

  private double interpolatedInRow(double u, int j, int k) {
    int i = (int) u;
    double low = value(i, j, k);
    double fraction = u - i;
    return fraction == 0 ? low : low + fraction * (value(i + 1, j, k) - low);
  }

  /**
   * {@return the levels of {@link #LEVELS} voxels of a row, (i,j,k) and the next ones along x, one
   * byte each, the first in the lowest byte} All must lie in the grid. Several times as fast as
   * {@link #value}.
   *
   * @param i the first voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param quantizer makes the level of each value
   */
  public abstract long levels(int i, int j, int k, GreyQuantizer quantizer);

  /**
   * Stores the value of a voxel of the grid, rounded and clamped to the range of the storage.
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param value the value, in the unit of the file
   */
  public abstract void set(int i, int j, int k, double value);

  final int indexInSlice(int i, int j, int k) {
    assert grid.contains(i, j, k) : "voxel lies outside: voxel=" + i + "," + j + "," + k;
    return j * sizeX + i;
  }

  private int nearestInteger(double value) {
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
    public long levels(int i, int j, int k, GreyQuantizer quantizer) {
      byte[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= quantizer.ofStored(slice[from + n] & 0xff) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (byte) super.nearestInteger(value);
    }
  }

  private static final class OfShorts extends ScalarVolume {
    private final short[][] slices;
    private final int mask;

    OfShorts(VoxelGrid grid, Storage storage, short[][] slices) {
      super(grid, storage);
      this.slices = slices;
      mask = storage == Storage.UINT16 ? 0xffff : -1; // a mask of all ones keeps the sign
    }

    @Override
    public double value(int i, int j, int k) {
      return slices[k][indexInSlice(i, j, k)] & mask;
    }

    @Override
    public long levels(int i, int j, int k, GreyQuantizer quantizer) {
      short[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= quantizer.ofStored(slice[from + n] & mask) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (short) super.nearestInteger(value);
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
    public long levels(int i, int j, int k, GreyQuantizer quantizer) {
      float[] slice = slices[k];
      int from = indexInSlice(i, j, k);
      long levels = 0;
      for (int n = 0; n < LEVELS; n++) {
        levels |= (long) quantizer.of(slice[from + n]) << (8 * n);
      }
      return levels;
    }

    @Override
    public void set(int i, int j, int k, double value) {
      slices[k][indexInSlice(i, j, k)] = (float) value;
    }
  }
}
