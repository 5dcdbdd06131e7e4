package org.palpate.io.nrrd;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorInputStream;
import org.palpate.io.codec.HexInputStream;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.BinarySampleStream;
import org.palpate.io.format.ConcatenatedInputStream;
import org.palpate.io.format.HeaderLineReader;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.Scaling;
import org.palpate.io.format.TextSampleStream;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelType;

/**
 * The position and encoding of a NRRD's samples.
 *
 * @param header the header
 * @param type the type of a sample
 * @param order the byte order of a sample
 * @param encoding the encoding of the bytes
 * @param lineSkip lines before the data of each file
 * @param byteSkip bytes after those lines, -1 if the data are the last bytes
 * @param bytesPerFile decoded bytes in each file
 * @param files the data files; the header's own if the data are attached
 */
record NrrdData(
    NrrdHeader header,
    VoxelType type,
    ByteOrder order,
    Encoding encoding,
    long lineSkip,
    long byteSkip,
    long bytesPerFile,
    List<Path> files)
    implements SampleStream.Opener {

  /** The most bytes before data that are found from the end of a file. */
  private static final long MAX_BYTES_BEFORE_DATA = 1 << 24;

  /** The encodings, each with the most bytes that one encoded byte can become. */
  enum Encoding {
    RAW("raw", 1),
    TEXT("text", 4.1), // "1 " is a float
    HEX("hexadecimal", 0.51),
    GZIP("gzip", 1032), // the limit of deflate
    BZIP2("bzip2", 2e6);

    private final String description;
    private final double maxExpansion;

    Encoding(String description, double maxExpansion) {
      this.description = description;
      this.maxExpansion = maxExpansion;
    }

    /** Returns the encoding in words. */
    String description() {
      return description;
    }
  }

  /**
   * Locates the data of a header, and checks that the files are long enough.
   *
   * @throws VolumeFormatException if a file is missing or too short
   */
  static NrrdData of(NrrdHeader header, VoxelType type, long samples) throws VolumeFormatException {
    Encoding encoding = encoding(header);
    List<Path> files = NrrdDataFiles.of(header);
    long bytes = samples * type.bytes();
    if (bytes % files.size() != 0) {
      throw header.refusal(
          bytes + " bytes of data cannot be split evenly over " + files.size() + " files");
    }
    NrrdData data =
        new NrrdData(
            header,
            type,
            order(header, type, encoding),
            encoding,
            skip(header, "line skip", 0),
            skip(header, "byte skip", -1),
            bytes / files.size(),
            files);
    for (Path file : files) {
      data.requireFileLength(file);
      data.requireBzip2Length(file);
    }
    return data;
  }

  /** Whether the data follow the header in the same file. */
  boolean isAttached() {
    return header.field("data file").isEmpty();
  }

  @Override
  public SampleStream open() throws IOException {
    long each = encoding == Encoding.TEXT ? Long.MAX_VALUE : bytesPerFile;
    InputStream all =
        files.size() == 1
            ? decoded(files.get(0))
            : new ConcatenatedInputStream(files, this::decoded, each);
    return encoding == Encoding.TEXT
        ? new TextSampleStream(all, type)
        : new BinarySampleStream(all, type, order, Scaling.NONE);
  }

  private InputStream decoded(Path file) throws IOException {
    InputStream in = InputFiles.open(file, isAttached() ? header.dataOffset() : 0);
    try {
      HeaderLineReader lines = new HeaderLineReader(in, file);
      for (long n = 0; n < lineSkip; n++) {
        if (lines.next() == null) {
          throw new VolumeFormatException(
              "the file has fewer than the " + lineSkip + " lines to skip",
              file,
              "correct 'line skip'");
        }
      }
      return skipBytes(decompressed(in), file);
    } catch (IOException e) {
      in.close();
      throw e;
    }
  }

  private InputStream decompressed(InputStream in) throws IOException {
    return switch (encoding) {
      case RAW, TEXT -> in;
      case HEX -> new HexInputStream(in);
      case GZIP -> new GZIPInputStream(in, InputFiles.BUFFER_BYTES);
      case BZIP2 -> new BZip2CompressorInputStream(in, true);
    };
  }

  private InputStream skipBytes(InputStream in, Path file) throws IOException {
    in.skipNBytes(byteSkip >= 0 ? byteSkip : bytesBeforeLast(file));
    return in;
  }

  /** Returns the number of bytes before the last ones; counts them if they are compressed. */
  private long bytesBeforeLast(Path file) throws IOException {
    if (encoding == Encoding.RAW) {
      return InputFiles.length(file) - (isAttached() ? header.dataOffset() : 0) - bytesPerFile;
    }
    try (InputStream in =
        decompressed(InputFiles.open(file, isAttached() ? header.dataOffset() : 0))) {
      byte[] buffer = new byte[InputFiles.BUFFER_BYTES];
      long count = 0;
      for (int got = in.read(buffer); got >= 0; got = in.read(buffer)) {
        count += got;
        if (count - bytesPerFile > MAX_BYTES_BEFORE_DATA) {
          throw new VolumeFormatException(
              "the data are far longer than the sizes allow", file, "correct the sizes");
        }
      }
      return Math.max(0, count - bytesPerFile);
    }
  }

  /** Refuses a file that is too short for its data, however well these are compressed. */
  private void requireFileLength(Path file) throws VolumeFormatException {
    long length = InputFiles.length(file) - (isAttached() ? header.dataOffset() : 0);
    double most = Math.max(0, length) * encoding.maxExpansion;
    if (encoding == Encoding.TEXT) {
      most = (length + 1) / 2.0 * type.bytes();
    }
    if ((double) bytesPerFile + Math.max(0, byteSkip) > most) {
      throw InputFiles.truncatedFile(
          file,
          (double) bytesPerFile,
          (double) length,
          encoding == Encoding.RAW ? "" : encoding.description());
    }
  }

  /**
   * Counts the bytes of a bzip2 file that promises much, because its compression has no useful
   * bound.
   */
  private void requireBzip2Length(Path file) throws VolumeFormatException {
    double plausible = (double) InputFiles.length(file) * BinaryData.MAX_DEFLATE_RATIO;
    if (encoding != Encoding.BZIP2 || bytesPerFile <= plausible) {
      return;
    }
    try (InputStream in = decoded(file)) {
      in.skipNBytes(bytesPerFile);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the header promises "
              + NumberText.count((double) bytesPerFile)
              + " bytes of data but the file has fewer",
          file,
          "copy the file again",
          e);
    }
  }

  private static Encoding encoding(NrrdHeader header) throws VolumeFormatException {
    String name = header.required("encoding").toLowerCase(Locale.ROOT);
    return switch (name) {
      case "raw" -> Encoding.RAW;
      case "txt", "text", "ascii" -> Encoding.TEXT;
      case "hex" -> Encoding.HEX;
      case "gz", "gzip" -> Encoding.GZIP;
      case "bz2", "bzip2" -> Encoding.BZIP2;
      default -> throw header.refusal("the encoding '" + name + "' is unknown");
    };
  }

  private static ByteOrder order(NrrdHeader header, VoxelType type, Encoding encoding)
      throws VolumeFormatException {
    boolean matters = type.bytes() > 1 && encoding != Encoding.TEXT;
    String endian = header.fields().getOrDefault("endian", matters ? "" : "little");
    return switch (endian.toLowerCase(Locale.ROOT)) {
      case "little" -> ByteOrder.LITTLE_ENDIAN;
      case "big" -> ByteOrder.BIG_ENDIAN;
      case "" -> throw header.refusal("the header does not say the byte order ('endian')");
      default -> throw header.refusal("the endian '" + endian + "' is neither little nor big");
    };
  }

  private static long skip(NrrdHeader header, String field, long lowest)
      throws VolumeFormatException {
    String text = header.fields().getOrDefault(field, "0");
    try {
      long value = Long.parseLong(text);
      if (value >= lowest) {
        return value;
      }
    } catch (NumberFormatException e) {
      // refused below, like a number that is too low
    }
    throw header.refusal("the '" + field + "' is '" + text + "'");
  }
}
