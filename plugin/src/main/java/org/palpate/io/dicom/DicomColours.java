package org.palpate.io.dicom;

import org.palpate.io.dicom.TransferSyntax.Coding;
import org.palpate.io.format.Luminance;

/**
 * Turns the 8-bit colours of DICOM into luminance.
 *
 * <p>Source: DICOM PS3.3, C.7.6.3.1.2.
 */
final class DicomColours {
  private DicomColours() {}

  /** Whether the pixels of a file are colours. */
  static boolean isColour(DicomFile dicom) {
    return dicom.samples() > 1;
  }

  /** Whether the colours of a file can be turned into luminance. */
  static boolean isReadable(DicomFile dicom) {
    String photometric = dicom.attributes().text(DicomTag.PHOTOMETRIC);
    Coding coding = dicom.syntax().coding();
    boolean whole = photometric.equals("RGB") || photometric.equals("YBR_FULL");
    boolean plain = (coding == Coding.PLAIN || coding == Coding.RLE) && whole;
    boolean jpeg = coding == Coding.JPEG && (whole || photometric.equals("YBR_FULL_422"));
    return dicom.samples() == 3 && dicom.bitsAllocated() == 8 && (plain || jpeg);
  }

  /** Writes the luminance of {@code count} pixels, three bytes each, into {@code dest}. */
  static void toLuminance(DicomFile dicom, byte[] bytes, boolean planar, int count, int[] dest) {
    boolean luminanceFirst = !dicom.attributes().text(DicomTag.PHOTOMETRIC).equals("RGB");
    int step = planar ? 1 : 3;
    int plane = planar ? count : 1;
    for (int n = 0; n < count; n++) {
      int at = n * step;
      int first = bytes[at] & 0xff;
      dest[n] =
          luminanceFirst
              ? first
              : Luminance.of(first, bytes[at + plane] & 0xff, bytes[at + 2 * plane] & 0xff);
    }
  }
}
