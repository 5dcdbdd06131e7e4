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
 * The bytes of a NIfTI header, by name.
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
 * <p>Source: nifti1.h and nifti2.h, nifti.nimh.nih.gov.
 */
final class NiftiHeader {
  private static final int LENGTH_1 = 348;
  private static final int LENGTH_2 = 540;

  private final Path file;
  private final ByteBuffer bytes;
  private final boolean second;
  private final boolean pair;

  private NiftiHeader(Path file, ByteBuffer bytes, boolean second, boolean pair) {
    this.file = file;
    this.bytes = bytes;
    this.second = second;
    this.pair = pair;
  }

  /** Whether bytes at the start of a file, decompressed, are such a header's. */
  static boolean isNifti(byte[] start) {
    if (start.length < LENGTH_1) {
      return false;
    }
    ByteBuffer bytes = ByteBuffer.wrap(start).order(order(start));
    String magic = magic(start, bytes.getInt(0) == LENGTH_2);
    return magic.equals("n+1") || magic.equals("ni1") || magic.equals("n+2") || magic.equals("ni2");
  }

  static NiftiHeader read(Path file) throws VolumeFormatException {
    byte[] start = firstBytes(file);
    if (start.length < LENGTH_1) {
      throw new VolumeFormatException(
          "it ends inside its header", file, "copy or export the file again");
    }
    ByteBuffer bytes = ByteBuffer.wrap(start).order(order(start));
    boolean second = bytes.getInt(0) == LENGTH_2 && start.length >= LENGTH_2;
    String magic = magic(start, second);
    boolean known = second ? magic.matches("n[+i]2") : magic.matches("n[+i]1");
    if (!known || (!second && bytes.getInt(0) != LENGTH_1)) {
      throw new VolumeFormatException(
          "it has not the header of a NIfTI file (an old Analyze file has none)",
          file,
          "convert it to NIfTI with the tool it came from");
    }
    return new NiftiHeader(file, bytes, second, magic.charAt(1) == 'i');
  }

  /** The first bytes of the file, decompressed where it is gzip. */
  static byte[] firstBytes(Path file) throws VolumeFormatException {
    byte[] two = InputFiles.firstBytes(file, 2);
    if (!BinaryData.isGzip(two)) {
      return InputFiles.firstBytes(file, LENGTH_2);
    }
    try (InputStream in = new GZIPInputStream(InputFiles.open(file, 0))) {
      return in.readNBytes(LENGTH_2);
    } catch (IOException e) {
      throw new VolumeFormatException(
          "its gzip data are damaged", file, "copy or export the file again", e);
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

  Path file() {
    return file;
  }

  ByteOrder order() {
    return bytes.order();
  }

  boolean isPair() {
    return pair;
  }

  int length() {
    return second ? LENGTH_2 : LENGTH_1;
  }

  String formatName() {
    return second ? "NIfTI-2" : "NIfTI-1";
  }

  long dim(int n) {
    return second ? bytes.getLong(16 + 8 * n) : bytes.getShort(40 + 2 * n);
  }

  int datatype() {
    return bytes.getShort(second ? 12 : 70);
  }

  double pixdim(int n) {
    return real(76, 104, n);
  }

  double voxOffset() {
    return second ? bytes.getLong(168) : bytes.getFloat(108);
  }

  double slope() {
    return real(112, 176, 0);
  }

  double intercept() {
    return real(112, 176, 1);
  }

  /** Whether the file says itself that its values are labels. */
  boolean isLabels() {
    return (second ? bytes.getInt(504) : bytes.getShort(68)) == 1002;
  }

  /** The code of the unit of length: 1 metre, 2 mm, 3 micrometre, 0 unknown. */
  int lengthUnit() {
    return (second ? bytes.getInt(500) : bytes.get(123)) & 7;
  }

  int qformCode() {
    return second ? bytes.getInt(344) : bytes.getShort(252);
  }

  int sformCode() {
    return second ? bytes.getInt(348) : bytes.getShort(254);
  }

  /** Quaternion b, c, d and offset x, y, z. */
  double quatern(int n) {
    return real(256, 352, n);
  }

  /** Row and column of the affine matrix. */
  double srow(int row, int column) {
    return real(280, 400, 4 * row + column);
  }

  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(what, file, "write the file anew with the tool it came from");
  }

  private double real(int first, int secondOffset, int n) {
    return second ? bytes.getDouble(secondOffset + 8 * n) : bytes.getFloat(first + 4 * n);
  }
}
