package org.palpate.io.volume;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32;

/**
 * Computes the CRC-32 of a volume's values as little-endian doubles, x fastest. It equals {@code
 * zlib.crc32(array.astype('<f8').tobytes(order='F'))} of the array that a reference reader gives.
 */
public final class VoxelCrc implements SliceSink {
  private final CRC32 crc = new CRC32();
  private int slices;

  /** Reads a volume and returns its checksum in hexadecimal. */
  public static String of(VolumeReader reader) throws VolumeFormatException {
    VoxelCrc sum = new VoxelCrc();
    reader.read(sum);
    if (sum.slices != reader.header().grid().sizeZ()) {
      throw new AssertionError("slices=" + sum.slices);
    }
    return String.format("%08x", sum.crc.getValue());
  }

  @Override
  public void accept(int k, VoxelSlice slice) {
    if (k != slices++) {
      throw new AssertionError("slice out of order: k=" + k);
    }
    ByteBuffer bytes = ByteBuffer.allocate(8 * slice.count()).order(ByteOrder.LITTLE_ENDIAN);
    for (int n = 0; n < slice.count(); n++) {
      bytes.putDouble(slice.value(n));
    }
    crc.update(bytes.flip());
  }
}
