package org.palpate.io.volume;

/** The type of number that a file stores for a voxel. */
public enum VoxelType {
  INT8(1, "signed 8 bit", -128, 127),
  UINT8(1, "unsigned 8 bit", 0, 255),
  INT16(2, "signed 16 bit", -32768, 32767),
  UINT16(2, "unsigned 16 bit", 0, 65535),
  INT32(4, "signed 32 bit", Integer.MIN_VALUE, Integer.MAX_VALUE),
  UINT32(4, "unsigned 32 bit", 0, 4294967295.0),
  INT64(8, "signed 64 bit", -0x1p63, 0x1p63),
  UINT64(8, "unsigned 64 bit", 0, 0x1p64),
  FLOAT32(4, "32 bit floating point", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY),
  FLOAT64(8, "64 bit floating point", Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  private final int bytes;
  private final String description;
  private final double low;
  private final double high;

  VoxelType(int bytes, String description, double low, double high) {
    this.bytes = bytes;
    this.description = description;
    this.low = low;
    this.high = high;
  }

  /** Returns the size of a voxel in bytes. */
  public int bytes() {
    return bytes;
  }

  /** Returns the type in words, as in "unsigned 16 bit". */
  public String description() {
    return description;
  }

  /** Returns the lowest value of the type. */
  public double low() {
    return low;
  }

  /** Returns the highest value of the type; for 64-bit integers the nearest double. */
  public double high() {
    return high;
  }

  /** Whether the type holds integers only. */
  public boolean isInteger() {
    return this != FLOAT32 && this != FLOAT64;
  }

  /** Whether every value of the type fits an {@code int}. */
  public boolean fitsInt() {
    return low >= Integer.MIN_VALUE && high <= Integer.MAX_VALUE;
  }
}
