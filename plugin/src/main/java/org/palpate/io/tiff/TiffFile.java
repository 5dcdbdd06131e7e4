package org.palpate.io.tiff;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The directories of a TIFF or BigTIFF file: for each page a map from tags to numbers.
 *
 * <p>Source: TIFF Revision 6.0; the BigTIFF design of libtiff.
 */
final class TiffFile {
  private static final int MAX_PAGES = 100_000;
  private static final int MAX_TAGS = 4096;
  private static final int MAX_VALUES = 1 << 22;

  private final Path file;
  private final long length;
  private ByteOrder order = ByteOrder.LITTLE_ENDIAN;
  private boolean big;
  private final List<Map<Integer, double[]>> pages = new ArrayList<>();

  private TiffFile(Path file) throws VolumeFormatException {
    this.file = file;
    length = InputFiles.length(file);
  }

  /** Returns whether a file with these first bytes is a TIFF file. */
  static boolean isTiff(byte[] start) {
    if (start.length < 4 || start[0] != start[1] || (start[0] != 'I' && start[0] != 'M')) {
      return false;
    }
    int version = start[0] == 'I' ? start[2] | start[3] << 8 : start[3] | start[2] << 8;
    return version == 42 || version == 43;
  }

  /** Reads the directories of a file, and no pixel. */
  static TiffFile read(Path file) throws VolumeFormatException {
    TiffFile tiff = new TiffFile(file);
    try (FileChannel channel = FileChannel.open(file)) {
      tiff.readDirectories(channel);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (EOFException e) {
      throw new VolumeFormatException(
          "a directory is outside the file", file, "copy or export the file again", e);
    } catch (IOException e) {
      throw InputFiles.unreadableFile(file, e);
    }
    return tiff;
  }

  /** Returns the path of the file. */
  Path file() {
    return file;
  }

  /** Returns the byte order. */
  ByteOrder order() {
    return order;
  }

  /** Returns the length of the file in bytes. */
  long length() {
    return length;
  }

  /** Returns for each page the values by tag; a text has one value for each byte. */
  List<Map<Integer, double[]>> pages() {
    return pages;
  }

  private void readDirectories(FileChannel channel) throws IOException {
    ByteBuffer head = bytes(channel, 0, (int) Math.min(16, length));
    order = head.get(0) == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    head.order(order);
    big = head.getShort(2) == 43;
    if (head.limit() < (big ? 16 : 8)) {
      throw new EOFException("header");
    }
    Set<Long> seen = new HashSet<>();
    long at = big ? head.getLong(8) : head.getInt(4) & 0xffffffffL;
    while (at != 0) {
      if (!seen.add(at) || seen.size() > MAX_PAGES) {
        throw new VolumeFormatException(
            "the list of pages has no end", file, "export the file again");
      }
      at = readDirectory(channel, at);
    }
  }

  private long readDirectory(FileChannel channel, long at) throws IOException {
    int countBytes = big ? 8 : 2;
    ByteBuffer head = bytes(channel, at, countBytes);
    long count = big ? head.getLong(0) : head.getShort(0) & 0xffff;
    if (count < 1 || count > MAX_TAGS) {
      throw new VolumeFormatException(
          "a page has " + count + " tags", file, "export the file again");
    }
    int entryBytes = big ? 20 : 12;
    ByteBuffer body = bytes(channel, at + countBytes, (int) count * entryBytes + (big ? 8 : 4));
    Map<Integer, double[]> page = new HashMap<>();
    for (int n = 0; n < count; n++) {
      readEntry(channel, body.slice(n * entryBytes, entryBytes).order(order), page);
    }
    pages.add(page);
    int next = (int) count * entryBytes;
    return big ? body.getLong(next) : body.getInt(next) & 0xffffffffL;
  }

  private void readEntry(FileChannel channel, ByteBuffer entry, Map<Integer, double[]> page)
      throws IOException {
    int tag = entry.getShort(0) & 0xffff;
    int type = entry.getShort(2) & 0xffff;
    long count = big ? entry.getLong(4) : entry.getInt(4) & 0xffffffffL;
    int size = sizeOf(type);
    if (size == 0 || !TiffPage.KNOWN_TAGS.contains(tag)) {
      return;
    }
    if (count < 0 || count > MAX_VALUES) {
      throw new VolumeFormatException(
          "the tag " + tag + " has " + count + " values", file, "export the file again");
    }
    int valueAt = big ? 12 : 8;
    ByteBuffer values =
        count * size <= (big ? 8 : 4)
            ? entry.slice(valueAt, (int) count * size).order(order)
            : bytes(
                channel,
                big ? entry.getLong(valueAt) : entry.getInt(valueAt) & 0xffffffffL,
                (int) count * size);
    double[] numbers = new double[(int) count];
    for (int n = 0; n < count; n++) {
      numbers[n] = number(values, n * size, type);
    }
    page.put(tag, numbers);
  }

  private static int sizeOf(int type) {
    return switch (type) {
      case 1, 2, 6, 7 -> 1;
      case 3, 8 -> 2;
      case 4, 9, 11, 13 -> 4;
      case 5, 10, 12, 16, 17, 18 -> 8;
      default -> 0;
    };
  }

  private static double number(ByteBuffer values, int at, int type) {
    return switch (type) {
      case 3 -> values.getShort(at) & 0xffff;
      case 8 -> values.getShort(at);
      case 4, 13 -> values.getInt(at) & 0xffffffffL;
      case 9 -> values.getInt(at);
      case 5 -> (double) (values.getInt(at) & 0xffffffffL) / (values.getInt(at + 4) & 0xffffffffL);
      case 10 -> (double) values.getInt(at) / values.getInt(at + 4);
      case 11 -> values.getFloat(at);
      case 12 -> values.getDouble(at);
      case 16, 17, 18 -> (double) values.getLong(at);
      case 6 -> values.get(at);
      default -> values.get(at) & 0xff;
    };
  }

  private ByteBuffer bytes(FileChannel channel, long at, int count) throws IOException {
    if (at < 0 || at > length - count) {
      throw new EOFException("tag");
    }
    ByteBuffer buffer = ByteBuffer.allocate(count).order(order);
    while (buffer.hasRemaining()) {
      if (channel.read(buffer, at + buffer.position()) < 0) {
        throw new EOFException("tag");
      }
    }
    return buffer.flip().order(order);
  }
}
