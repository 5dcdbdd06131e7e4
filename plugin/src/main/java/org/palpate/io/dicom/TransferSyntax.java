package org.palpate.io.dicom;

import java.util.Map;

/**
 * The encoding of a DICOM file.
 *
 * <p>Source: DICOM PS3.5 section 10 and annex A.
 *
 * @param name the name in the standard
 * @param coding the coding of the pixels
 */
record TransferSyntax(String name, Coding coding) {
  static final String DEFLATED = "1.2.840.10008.1.2.1.99";
  static final String IMPLICIT = "1.2.840.10008.1.2";
  static final String BIG_ENDIAN = "1.2.840.10008.1.2.2";

  /** The coding of pixels. */
  enum Coding {
    PLAIN,
    RLE,
    JPEG_LOSSLESS,
    JPEG_2000,
    UNREADABLE
  }

  private static final String JPEG = "1.2.840.10008.1.2.4.";

  private static final Map<String, TransferSyntax> KNOWN =
      Map.ofEntries(
          Map.entry(IMPLICIT, new TransferSyntax("Implicit VR Little Endian", Coding.PLAIN)),
          Map.entry(
              "1.2.840.10008.1.2.1", new TransferSyntax("Explicit VR Little Endian", Coding.PLAIN)),
          Map.entry(
              DEFLATED, new TransferSyntax("Deflated Explicit VR Little Endian", Coding.PLAIN)),
          Map.entry(BIG_ENDIAN, new TransferSyntax("Explicit VR Big Endian", Coding.PLAIN)),
          Map.entry("1.2.840.10008.1.2.5", new TransferSyntax("RLE Lossless", Coding.RLE)),
          Map.entry(JPEG + "57", new TransferSyntax("JPEG Lossless", Coding.JPEG_LOSSLESS)),
          Map.entry(
              JPEG + "70",
              new TransferSyntax("JPEG Lossless, first-order prediction", Coding.JPEG_LOSSLESS)),
          Map.entry(JPEG + "90", new TransferSyntax("JPEG 2000, lossless only", Coding.JPEG_2000)),
          Map.entry(JPEG + "91", new TransferSyntax("JPEG 2000", Coding.JPEG_2000)),
          Map.entry(JPEG + "50", new TransferSyntax("JPEG Baseline", Coding.UNREADABLE)),
          Map.entry(JPEG + "51", new TransferSyntax("JPEG Extended", Coding.UNREADABLE)),
          Map.entry(JPEG + "80", new TransferSyntax("JPEG-LS Lossless", Coding.UNREADABLE)),
          Map.entry(JPEG + "81", new TransferSyntax("JPEG-LS Near-Lossless", Coding.UNREADABLE)),
          Map.entry(JPEG + "92", new TransferSyntax("JPEG 2000 Part 2", Coding.UNREADABLE)),
          Map.entry(JPEG + "93", new TransferSyntax("JPEG 2000 Part 2", Coding.UNREADABLE)),
          Map.entry(
              JPEG + "201", new TransferSyntax("High-Throughput JPEG 2000", Coding.UNREADABLE)),
          Map.entry(
              JPEG + "202", new TransferSyntax("High-Throughput JPEG 2000", Coding.UNREADABLE)),
          Map.entry(
              JPEG + "203", new TransferSyntax("High-Throughput JPEG 2000", Coding.UNREADABLE)));

  /** Returns the syntax of a UID; an unknown one is unreadable. */
  static TransferSyntax of(String uid) {
    String shown = uid.matches("[0-9.]{1,64}") ? uid : "without a name";
    return KNOWN.getOrDefault(
        uid, new TransferSyntax("transfer syntax " + shown, Coding.UNREADABLE));
  }
}
