package org.palpate.io.format;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPInputStream;
import java.util.zip.InflaterInputStream;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelType;

/**
 * The samples of a volume in one file, or split evenly over several, at an offset and perhaps
 * compressed.
 *
 * @param files in the order of the samples
 * @param start where the data begin
 * @param type the type of a sample
 * @param order the byte order of a sample
 * @param scaling maps stored numbers to values
 * @param byteCount decompressed bytes over all files
 */
public record BinaryData(
    List<Path> files, Start start, VoxelType type, ByteOrder order, Scaling scaling, long byteCount)
    implements SampleStream.Opener {

  /** The most bytes that deflate makes of one byte. */
  public static final int MAX_DEFLATE_RATIO = 1032;

  /**
   * The start of the data in a file.
   *
   * @param offset bytes before the data, or {@link #AT_END} if the data are the last bytes
   * @param deflated whether a zlib or gzip stream follows the offset
   * @param insideGzip whether the whole file is gzip and the offset counts decompressed bytes
   */
  public record Start(long offset, boolean deflated, boolean insideGzip) {
    static final long AT_END = -1;
  }

  /**
   * Checks that the files are long enough for their data, however well these are compressed.
   *
   * @throws VolumeFormatException if a file is too short
   */
  public void requireFileLengths() throws VolumeFormatException {
    double each = (double) byteCount / files.size();
    if (byteCount % files.size() != 0) {
      throw new VolumeFormatException(
          byteCount + " bytes of data cannot be split evenly over " + files.size() + " files",
          files.get(0),
          "correct the sizes or the list of files");
    }
    for (Path file : files) {
      long length = InputFiles.length(file);
      double offset = Math.max(0, start.offset());
      double most = length - offset;
      if (isCompressed()) {
        most = (double) length * MAX_DEFLATE_RATIO - (start.insideGzip() ? offset : 0);
      }
      if (each > most) {
        throw InputFiles.truncatedFile(
            file,
            each,
            length - (start.insideGzip() ? 0 : offset),
            isCompressed() ? "compressed" : "");
      }
    }
  }

  private boolean isCompressed() {
    return start.deflated() || start.insideGzip();
  }

  @Override
  public SampleStream open() throws IOException {
    InputStream all =
        files.size() == 1
            ? decoded(files.get(0))
            : new ConcatenatedInputStream(files, this::decoded, byteCount / files.size());
    return new BinarySampleStream(all, type, order, scaling);
  }

  private InputStream decoded(Path file) throws IOException {
    long offset =
        start.offset() == Start.AT_END
            ? InputFiles.length(file) - byteCount / files.size()
            : start.offset();
    if (start.insideGzip()) {
      InputStream in = new GZIPInputStream(InputFiles.open(file, 0), InputFiles.BUFFER_BYTES);
      in.skipNBytes(offset);
      return in;
    }
    InputStream in = InputFiles.open(file, offset);
    return start.deflated() ? inflated(in) : in;
  }

  private static InputStream inflated(InputStream in) throws IOException {
    PushbackInputStream whole = new PushbackInputStream(in, 2);
    byte[] two = whole.readNBytes(2);
    whole.unread(two);
    return isGzip(two)
        ? new GZIPInputStream(whole, InputFiles.BUFFER_BYTES)
        : new InflaterInputStream(whole, new java.util.zip.Inflater(), InputFiles.BUFFER_BYTES);
  }

  /** Whether some bytes begin as a gzip stream does. */
  public static boolean isGzip(byte[] bytes) {
    return bytes.length >= 2 && (bytes[0] & 0xff) == 0x1f && (bytes[1] & 0xff) == 0x8b;
  }
}
