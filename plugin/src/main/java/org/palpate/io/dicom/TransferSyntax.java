package org.palpate.io.dicom;

import java.util.HashMap;
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
  static final String EXPLICIT = "1.2.840.10008.1.2.1";
  static final String IMPLICIT = "1.2.840.10008.1.2";
  static final String BIG_ENDIAN = "1.2.840.10008.1.2.2";

  private static final String NEAR_LOSSLESS = "JPEG-LS Near-Lossless";

  /** The coding of pixels. */
  enum Coding {
    PLAIN,
    RLE,
    JPEG,
    JPEG_LOSSLESS,
    JPEG_LS,
    JPEG_2000,
    UNREADABLE
  }

  private static final String JPEG = "1.2.840.10008.1.2.4.";

  private static final Map<String, TransferSyntax> KNOWN = known();

  private static Map<String, TransferSyntax> known() {
    Map<String, TransferSyntax> known = new HashMap<>();
    Object[][] readable = {
      {IMPLICIT, "Implicit VR Little Endian", Coding.PLAIN},
      {EXPLICIT, "Explicit VR Little Endian", Coding.PLAIN},
      {DEFLATED, "Deflated Explicit VR Little Endian", Coding.PLAIN},
      {BIG_ENDIAN, "Explicit VR Big Endian", Coding.PLAIN},
      {"1.2.840.10008.1.2.5", "RLE Lossless", Coding.RLE},
      {JPEG + "50", "JPEG Baseline", Coding.JPEG},
      {JPEG + "57", "JPEG Lossless", Coding.JPEG_LOSSLESS},
      {JPEG + "70", "JPEG Lossless, first-order prediction", Coding.JPEG_LOSSLESS},
      {JPEG + "80", "JPEG-LS Lossless", Coding.JPEG_LS},
      {JPEG + "81", NEAR_LOSSLESS, Coding.JPEG_LS},
      {JPEG + "90", "JPEG 2000, lossless only", Coding.JPEG_2000},
      {JPEG + "91", "JPEG 2000", Coding.JPEG_2000}
    };
    for (Object[] row : readable) {
      known.put((String) row[0], new TransferSyntax((String) row[1], (Coding) row[2]));
    }
    String[][] unreadable = {
      {"1.2.840.10008.1.2.1.98", "Encapsulated Uncompressed Explicit VR Little Endian"},
      {"1.2.840.10008.1.2.8.1", "Deflated Image Frame Compression"},
      {"1.2.840.113619.5.2", "GE Private Implicit VR Big Endian"},
      {JPEG + "51", "JPEG Extended"},
      {JPEG + "53", "JPEG Spectral Selection"},
      {JPEG + "55", "JPEG Full Progression"},
      {JPEG + "58", "JPEG Lossless, Hierarchical"},
      {JPEG + "92", "JPEG 2000 Part 2, lossless only"},
      {JPEG + "93", "JPEG 2000 Part 2"},
      {JPEG + "94", "JPIP Referenced"},
      {JPEG + "95", "JPIP Referenced Deflate"},
      {JPEG + "100", "MPEG-2 Main Profile, Main Level"},
      {JPEG + "100.1", "MPEG-2 Main Profile, Main Level"},
      {JPEG + "101", "MPEG-2 Main Profile, High Level"},
      {JPEG + "101.1", "MPEG-2 Main Profile, High Level"},
      {JPEG + "102", "MPEG-4 AVC/H.264 High Profile 4.1"},
      {JPEG + "102.1", "MPEG-4 AVC/H.264 High Profile 4.1"},
      {JPEG + "103", "MPEG-4 AVC/H.264 BD-compatible High Profile 4.1"},
      {JPEG + "104", "MPEG-4 AVC/H.264 High Profile 4.2 for 2D video"},
      {JPEG + "105", "MPEG-4 AVC/H.264 High Profile 4.2 for 3D video"},
      {JPEG + "106", "MPEG-4 AVC/H.264 Stereo High Profile 4.2"},
      {JPEG + "107", "HEVC/H.265 Main Profile 5.1"},
      {JPEG + "108", "HEVC/H.265 Main 10 Profile 5.1"},
      {JPEG + "110", "JPEG XL Lossless"},
      {JPEG + "111", "JPEG XL JPEG Recompression"},
      {JPEG + "112", "JPEG XL"},
      {JPEG + "201", "High-Throughput JPEG 2000, lossless only"},
      {JPEG + "202", "High-Throughput JPEG 2000 with RPCL, lossless only"},
      {JPEG + "203", "High-Throughput JPEG 2000"}
    };
    for (String[] row : unreadable) {
      known.put(row[0], new TransferSyntax(row[1], Coding.UNREADABLE));
    }
    return Map.copyOf(known);
  }

  /** Whether the syntax allows a loss that its coding may avoid. */
  boolean isNearLossless() {
    return name.equals(NEAR_LOSSLESS);
  }

  /** Returns the syntax of a UID; an unknown one is unreadable. */
  static TransferSyntax of(String uid) {
    String shown = uid.matches("[0-9.]{1,64}") ? uid : "without a name";
    return KNOWN.getOrDefault(
        uid, new TransferSyntax("transfer syntax " + shown, Coding.UNREADABLE));
  }
}
