package org.palpate.io.nifti;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The fields of a NIfTI header, by their offsets in bytes. An Analyze 7.5 header has the sizes, the
 * type and the spacing at the same offsets as NIfTI-1, and no position.
 *
 * <pre>
 *              NIfTI-1        NIfTI-2
 *   length     0 int 348      0 int 540
 *   magic      344 char[4]    4 char[8]
 *   dim        40 short[8]    16 long[8]
 *   datatype   70 short       12 short
 *   pixdim     76 float[8]    104 double[8]
 *   vox_offset 108 float      168 long
 *   slope      112 float      176 double       intercept follows
 *   intent     68 short       504 int
 *   units      123 byte       500 int
 *   qform      252 short      344 int          sform code follows
 *   quatern    256 float[6]   352 double[6]    b c d x y z
 *   srow       280 float[12]  400 double[12]
 * </pre>
 *
 * <p>Source: nifti1.h and nifti2.h, nifti.nimh.nih.gov; dbh.h of Analyze 7.5.
 */
final class NiftiHeader {
  private static final int LENGTH_1 = 348;
  private static final int LENGTH_2 = 540;

  private final Path file;
  private final ByteBuffer bytes;
  private final boolean second;
  private final boolean pair;
  private final boolean analyze;

  private NiftiHeader(Path file, ByteBuffer bytes, boolean second, boolean pair, boolean analyze) {
    this.file = file;
    this.bytes = bytes;
    this.second = second;
    this.pair = pair;
    this.analyze = analyze;
  }

  /** Returns whether a file with these first bytes, decompressed, is a NIfTI file. */
  static boolean isNifti(byte[] start) {
    if (start.length < LENGTH_1) {
      return false;
    }
    ByteBuffer bytes = ByteBuffer.wrap(start).order(order(start));
    String magic = magic(start, bytes.getInt(0) == LENGTH_2);
    return magic.equals("n+1") || magic.equals("ni1") || magic.equals("n+2") || magic.equals("ni2");
  }

  /** Reads a header. */
  static NiftiHeader read(Path file) throws VolumeFormatException {
    byte[] start = firstBytes(file);
    if (start.length < LENGTH_1) {
      throw new VolumeFormatException(
          "the file ends inside its header", file, "copy or export the file again");
    }
    ByteBuffer bytes = ByteBuffer.wrap(start).order(order(start));
    boolean second = bytes.getInt(0) == LENGTH_2 && start.length >= LENGTH_2;
    String magic = magic(start, second);
    boolean lengthFits = second || bytes.getInt(0) == LENGTH_1;
    if (lengthFits && magic.matches(second ? "n[+i]2" : "n[+i]1")) {
      return new NiftiHeader(file, bytes, second, magic.charAt(1) == 'i', false);
    }
    int axes = bytes.getShort(40);
    boolean isAnalyze = lengthFits && !second && axes >= 2 && axes <= 7;
    if (isAnalyze && InputFiles.hasEnding(file, ".hdr", ".hdr.gz")) {
      return new NiftiHeader(file, bytes, false, true, true);
    }
    throw new VolumeFormatException(
        "the file has no header of NIfTI or Analyze 7.5",
        file,
        "export it again; an Analyze volume is a pair of files, .hdr and .img");
  }

  /** Returns the first bytes of a file, decompressed if it is gzip. */
  static byte[] firstBytes(Path file) throws VolumeFormatException {
    byte[] two = InputFiles.firstBytes(file, 2);
    if (!BinaryData.isGzip(two)) {
      return InputFiles.firstBytes(file, LENGTH_2);
    }
    try (InputStream in = new GZIPInputStream(InputFiles.open(file, 0))) {
      return in.readNBytes(LENGTH_2);
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the gzip stream is damaged", file, "copy or export the file again", e);
    }
  }

  private static ByteOrder order(byte[] start) {
    int little = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt(0);
    return little == LENGTH_1 || little == LENGTH_2
        ? ByteOrder.LITTLE_ENDIAN
        : ByteOrder.BIG_ENDIAN;
  }

  private static String magic(byte[] start, boolean second) {
    return new String(start, second ? 4 : 344, 3, StandardCharsets.ISO_8859_1);
  }

  /** Returns the path of the header. */
  Path file() {
    return file;
  }

  /** Returns the byte order of the file. */
  ByteOrder order() {
    return bytes.order();
  }

  /** Whether the data are in a second file. */
  boolean isPair() {
    return pair;
  }

  /** Whether the header is Analyze 7.5, which states no position. */
  boolean isAnalyze() {
    return analyze;
  }

  /** Returns the length of the header in bytes. */
  int length() {
    return second ? LENGTH_2 : LENGTH_1;
  }

  /** Returns the name of the format. */
  String formatName() {
    return analyze ? "Analyze 7.5" : second ? "NIfTI-2" : "NIfTI-1";
  }

  /** Returns the number of axes for n = 0, else the size along axis n. */
  long dim(int n) {
    return second ? bytes.getLong(16 + 8 * n) : bytes.getShort(40 + 2 * n);
  }

  /** Returns the code of the voxel type. */
  int datatype() {
    return bytes.getShort(second ? 12 : 70);
  }

  /** Returns the handedness for n = 0, else the spacing along axis n. */
  double pixdim(int n) {
    return real(76, 104, n);
  }

  /** Returns the offset of the data in bytes, which may be no integer in NIfTI-1. */
  double voxOffset() {
    return second ? bytes.getLong(168) : bytes.getFloat(108);
  }

  /** Returns the slope, 0 for no scaling. */
  double slope() {
    return analyze ? 0 : real(112, 176, 0);
  }

  /** Returns the intercept. */
  double intercept() {
    return real(112, 176, 1);
  }

  /** Whether the file declares that its values are labels. */
  boolean isLabels() {
    return !analyze && (second ? bytes.getInt(504) : bytes.getShort(68)) == 1002;
  }

  /** Returns the unit of length: 1 metre, 2 millimetre, 3 micrometre, 0 unknown. */
  int lengthUnit() {
    return analyze ? 0 : (second ? bytes.getInt(500) : bytes.get(123)) & 7;
  }

  /** Returns the code of the quaternion's coordinate system, 0 for none. */
  int qformCode() {
    return analyze ? 0 : second ? bytes.getInt(344) : bytes.getShort(252);
  }

  /** Returns the code of the matrix's coordinate system, 0 for none. */
  int sformCode() {
    return analyze ? 0 : second ? bytes.getInt(348) : bytes.getShort(254);
  }

  /** Returns quaternion b, c, d for n = 0 to 2 and offset x, y, z for n = 3 to 5. */
  double quatern(int n) {
    return real(256, 352, n);
  }

  /** Returns an element of the affine matrix. */
  double srow(int row, int column) {
    return real(280, 400, 4 * row + column);
  }

  /** Returns an exception that names the header. */
  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(what, file, "export the file again");
  }

  private double real(int first, int secondOffset, int n) {
    return second ? bytes.getDouble(secondOffset + 8 * n) : bytes.getFloat(first + 4 * n);
  }
}
