package org.palpate.io.tiff;

import java.nio.ByteBuffer;
import java.util.Locale;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

/**
 * The type in which ImageJ can hold the values of a volume: unsigned of 8 or 16 bits, signed of 16
 * bits stored with an offset, or floating point of 32 bits.
 */
public final class StackValues {
  private static final int OFFSET = 32768;

  private final int bytes;
  private final boolean offset;
  private final long rounded;

  private StackValues(int bytes, boolean offset, long rounded) {
    this.bytes = bytes;
    this.offset = offset;
    this.rounded = rounded;
  }

  /**
   * Returns the narrowest type for a volume. Reads all values if the header does not settle it.
   *
   * @throws VolumeFormatException if the volume cannot be read
   */
  public static StackValues of(VolumeReader volume) throws VolumeFormatException {
    VolumeHeader header = volume.header();
    if (header.type() == VoxelType.FLOAT32
        && header.values().equals(ValueRange.of(VoxelType.FLOAT32))) {
      return new StackValues(4, false, 0);
    }
    if (header.values().isInteger()) {
      StackValues type = ofIntegers(header.values().low(), header.values().high());
      if (type != null) {
        return type;
      }
    }
    Extremes found = new Extremes();
    volume.read(found::add);
    StackValues type = found.whole ? ofIntegers(found.low, found.high) : null;
    return type != null ? type : new StackValues(4, false, found.rounded);
  }

  private static StackValues ofIntegers(double low, double high) {
    if (low >= 0 && high <= 255) {
      return new StackValues(1, false, 0);
    }
    if (low >= 0 && high <= 65535) {
      return new StackValues(2, false, 0);
    }
    return low >= -OFFSET && high < OFFSET ? new StackValues(2, true, 0) : null;
  }

  /** Returns the bytes of a value. */
  public int bytes() {
    return bytes;
  }

  /** Whether the values are floating point. */
  public boolean isFloat() {
    return bytes == 4;
  }

  /** Whether 32768 is added to each value, which ImageJ's calibration takes away again. */
  public boolean isOffset() {
    return offset;
  }

  /** Returns the type in words, with the number of values that it rounds. */
  public String description() {
    String type = isFloat() ? "32 bit floating point" : 8 * bytes + " bit";
    return rounded == 0
        ? type + (offset ? ", signed" : "")
        : type + String.format(Locale.ROOT, " (%,d values are rounded to it)", rounded);
  }

  /** Stores the values of a slice in this type, in the byte order of {@code dest}. */
  public void put(VoxelSlice slice, ByteBuffer dest) {
    for (int n = 0; n < slice.count(); n++) {
      double value = slice.value(n);
      switch (bytes) {
        case 1 -> dest.put((byte) (int) value);
        case 2 -> dest.putShort((short) ((int) value + (offset ? OFFSET : 0)));
        default -> dest.putFloat((float) value);
      }
    }
  }

  /** The extremes of a volume, whether all values are whole, and how many a float rounds. */
  private static final class Extremes {
    private double low = Double.POSITIVE_INFINITY;
    private double high = Double.NEGATIVE_INFINITY;
    private boolean whole = true;
    private long rounded;

    void add(int k, VoxelSlice slice) {
      for (int n = 0; n < slice.count(); n++) {
        double value = slice.value(n);
        low = Math.min(low, value);
        high = Math.max(high, value);
        whole &= value == Math.rint(value);
        rounded += (float) value == value || Double.isNaN(value) ? 0 : 1;
      }
    }
  }
}
