package org.palpate.io.dicom;

import java.util.List;
import java.util.Map;
import org.palpate.io.dicom.DicomParser.PixelDataItem;
import org.palpate.io.dicom.TransferSyntax.Coding;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Checks that the pixels of a file are values of a volume, can be decoded, and are complete.
 *
 * <p>Source: DICOM PS3.3, C.7.6.3 and C.11.1.
 */
final class DicomImageChecks {
  private static final String SLIDE_CLASS = "1.2.840.10008.5.1.4.1.1.77.1.6";
  private static final String FOLDER_LIST_CLASS = "1.2.840.10008.1.3.10";

  /** The content of files without an image, by modality. */
  private static final Map<String, String> WITHOUT_IMAGE =
      Map.of(
          "RTSTRUCT", "contours (RTSTRUCT)",
          "RTPLAN", "a treatment plan (RTPLAN)",
          "SR", "a report (SR)",
          "KO", "a selection of images (KO)",
          "PR", "how to show other images (PR)",
          "REG", "a registration (REG)",
          "DOC", "a document (DOC)");

  private DicomImageChecks() {}

  /**
   * Checks a file of a series.
   *
   * @throws VolumeFormatException if its pixels are no values, or cannot be read
   */
  static void check(DicomFile dicom) throws VolumeFormatException {
    checkHasPixels(dicom);
    checkSyntax(dicom);
    checkKind(dicom);
    checkColour(dicom);
    checkBits(dicom);
    checkSize(dicom);
  }

  static void checkHasPixels(DicomFile dicom) throws VolumeFormatException {
    if (dicom.hasPixels()) {
      return;
    }
    String modality = dicom.attributes().text(DicomTag.MODALITY);
    if (dicom.attributes().text(DicomTag.SOP_CLASS).equals(FOLDER_LIST_CLASS)) {
      throw dicom.refusal(
          "the file is a DICOMDIR, a list of files", "name the folder that holds the images");
    }
    throw dicom.refusal(
        WITHOUT_IMAGE.containsKey(modality)
            ? "the file holds " + WITHOUT_IMAGE.get(modality) + " and no image"
            : "the file has no image",
        "give a file or folder of an image series");
  }

  static void checkSyntax(DicomFile dicom) throws VolumeFormatException {
    if (dicom.syntax().coding() == Coding.UNREADABLE) {
      throw dicom.refusal(
          "the image is compressed as " + dicom.syntax().name() + ", which cannot be read",
          DicomFile.CONVERT);
    }
    if ((dicom.syntax().coding() == Coding.PLAIN) == dicom.encapsulated()) {
      throw dicom.refusal(
          "the pixels are not encoded as the transfer syntax "
              + dicom.syntax().name()
              + " requires",
          DicomFile.CONVERT);
    }
  }

  /** Refuses images that hold no slice. */
  private static void checkKind(DicomFile dicom) throws VolumeFormatException {
    DicomDataSet attributes = dicom.attributes();
    if (attributes.text(DicomTag.IMAGE_TYPE).contains("MOSAIC")) {
      throw dicom.refusal(
          "the image is a Siemens mosaic, which holds all slices side by side in one picture",
          "convert it with dcm2niix (free), which writes a NIfTI volume");
    }
    if (attributes.text(DicomTag.SOP_CLASS).equals(SLIDE_CLASS)
        || attributes.text(DicomTag.MODALITY).equals("SM")) {
      throw dicom.refusal(
          "the file is a whole-slide image, whose frames are tiles of a microscope slide",
          "give a volume, for example a stack saved as TIFF");
    }
    if (!attributes.items(DicomTag.MODALITY_TABLE_SEQUENCE).isEmpty()) {
      throw dicom.refusal(
          "the values stand in a table (Modality LUT Sequence), which is not read",
          "export the series with rescale slope and intercept");
    }
  }

  private static void checkColour(DicomFile dicom) throws VolumeFormatException {
    String photometric = dicom.attributes().text(DicomTag.PHOTOMETRIC);
    if (photometric.equals("PALETTE COLOR")) {
      throw dicom.refusal(
          "the pixels are indices into a palette (PALETTE COLOR), not values",
          "export the series as grey values");
    }
    boolean colour = dicom.samples() != 1 || photometric.matches("RGB|YBR.*|ARGB|HSV|CMYK");
    if (colour && !DicomColours.isReadable(dicom)) {
      throw dicom.refusal(
          "the pixels are colours ("
              + dicom.samples()
              + " numbers each, "
              + shown(photometric)
              + ", "
              + dicom.syntax().name()
              + "), which cannot be read",
          "give a grey series, or convert it with gdcmconv --raw IN OUT (free, from GDCM)");
    }
  }

  private static String shown(String photometric) {
    return photometric.matches("[A-Z0-9_ ]{1,16}") ? photometric : "unknown";
  }

  private static void checkBits(DicomFile dicom) throws VolumeFormatException {
    int allocated = dicom.bitsAllocated();
    if (allocated == 1) {
      throw dicom.refusal(
          "the image has one bit a pixel and is no segmentation",
          "save it as a label volume (NRRD or NIfTI), for example with 3D Slicer");
    }
    boolean makeSense =
        dicom.bitsStored() >= 1
            && dicom.highBit() >= dicom.bitsStored() - 1
            && dicom.highBit() < allocated;
    if ((allocated != 8 && allocated != 16 && allocated != 32) || !makeSense) {
      throw dicom.refusal(
          "the pixels use "
              + dicom.bitsStored()
              + " of "
              + allocated
              + " bits, of which the highest is bit "
              + dicom.highBit(),
          DicomFile.CONVERT);
    }
  }

  /** Checks that the file holds as many pixels as its header promises. */
  static void checkSize(DicomFile dicom) throws VolumeFormatException {
    if (dicom.rows() < 1 || dicom.columns() < 1) {
      throw dicom.refusal(
          "the size is " + dicom.columns() + "x" + dicom.rows(), "export the file again");
    }
    boolean plain = dicom.syntax().coding() == Coding.PLAIN;
    List<PixelDataItem> items = dicom.pixelDataItems();
    double needed = Math.ceil((double) dicom.frameBits() * dicom.frameCount() / 8);
    if (plain && items.get(0).length() < needed) {
      throw InputFiles.truncatedFile(dicom.file(), needed, (double) items.get(0).length(), "");
    }
    requireInflatable(dicom, needed);
    if (!plain && items.size() < dicom.frameCount()) {
      throw dicom.refusal(
          "the header promises "
              + dicom.frameCount()
              + " frames but the file has "
              + items.size()
              + " fragments",
          "copy the file again; if that does not help, export it again");
    }
    if (!plain && dicom.frameCount() > 1 && items.size() != dicom.frameCount()) {
      throw dicom.refusal("a frame is split into several fragments", DicomFile.CONVERT);
    }
  }

  /** Refuses more pixels than the compressed bytes can hold. */
  private static void requireInflatable(DicomFile dicom, double needed)
      throws VolumeFormatException {
    double stored = 0;
    for (PixelDataItem piece : dicom.pixelDataItems()) {
      stored += piece.length();
    }
    double most =
        switch (dicom.syntax().coding()) {
          case RLE -> 64; // 128 bytes of 2
          case JPEG_LOSSLESS -> dicom.bitsAllocated(); // at least a bit for each pixel
          case JPEG_2000 -> 20_000; // a uniform image of 2000x2000 takes about 400 bytes
          case JPEG -> 1024; // at least a bit for each block of 64 pixels
          case JPEG_LS -> 1 << 17; // a run of 2^15 pixels may take one bit
          default -> Double.POSITIVE_INFINITY;
        };
    if (needed > stored * most) {
      throw InputFiles.truncatedFile(dicom.file(), needed, stored, "compressed");
    }
  }
}
