package org.palpate.io.dicom;

import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.palpate.io.dicom.TransferSyntax.Coding;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The segments of a DICOM segmentation object, and the segment that each frame shows.
 *
 * <p>Source: DICOM PS3.3, A.51 and C.8.20.
 *
 * @param dicom the file
 * @param kind how the pixels stand for segments
 * @param table names and colours by segment number
 * @param segmentOfFrame the segment number of each frame; all 0 in a label map
 */
record DicomSegmentation(
    DicomFile dicom, Kind kind, LabelTable table, List<Integer> segmentOfFrame) {
  private static final String SEGMENTATION_CLASS = "1.2.840.10008.5.1.4.1.1.66.4";
  private static final String LABEL_MAP_CLASS = "1.2.840.10008.5.1.4.1.1.66.7";
  private static final int WITHOUT_COLOUR = -1; // the builder of segments chooses one

  /** Character sets whose names in Java follow from those in DICOM. */
  private static final Map<String, String> CHARACTER_SETS =
      Map.ofEntries(
          Map.entry("ISO_IR 192", "UTF-8"),
          Map.entry("ISO_IR 101", "ISO-8859-2"),
          Map.entry("ISO_IR 109", "ISO-8859-3"),
          Map.entry("ISO_IR 110", "ISO-8859-4"),
          Map.entry("ISO_IR 144", "ISO-8859-5"),
          Map.entry("ISO_IR 127", "ISO-8859-6"),
          Map.entry("ISO_IR 126", "ISO-8859-7"),
          Map.entry("ISO_IR 138", "ISO-8859-8"),
          Map.entry("ISO_IR 148", "ISO-8859-9"),
          Map.entry("ISO_IR 13", "Shift_JIS"),
          Map.entry("GB18030", "GB18030"),
          Map.entry("GBK", "GBK"));

  /** The meaning of a pixel. */
  enum Kind {
    /** One bit a pixel; a frame shows one segment. */
    BINARY("binary"),
    /** A probability or occupancy a pixel; a frame shows one segment. */
    FRACTIONAL("fractional"),
    /** The number of the segment a pixel. */
    LABEL_MAP("label map");

    private final String text;

    Kind(String text) {
      this.text = text;
    }

    /** Returns the kind in words. */
    String text() {
      return text;
    }
  }

  /** Whether a file is a segmentation object. */
  static boolean isSegmentation(DicomFile dicom) {
    String sopClass = dicom.attributes().text(DicomTag.SOP_CLASS);
    return sopClass.equals(SEGMENTATION_CLASS)
        || sopClass.equals(LABEL_MAP_CLASS)
        || (dicom.attributes().text(DicomTag.MODALITY).equals("SEG")
            && !dicom.attributes().items(DicomTag.SEGMENT_SEQUENCE).isEmpty());
  }

  /**
   * Returns the segmentation of a file.
   *
   * @throws VolumeFormatException if its kind is unknown or it is incomplete
   */
  static DicomSegmentation of(DicomFile dicom) throws VolumeFormatException {
    DicomImageChecks.checkHasPixels(dicom);
    DicomImageChecks.checkSyntax(dicom);
    Kind kind = kind(dicom);
    checkBits(dicom, kind);
    DicomImageChecks.checkSize(dicom);
    LabelTable table = table(dicom);
    return new DicomSegmentation(dicom, kind, table, segmentOfFrame(dicom, kind, table));
  }

  private static Kind kind(DicomFile dicom) throws VolumeFormatException {
    String text = dicom.attributes().text(DicomTag.SEGMENTATION_KIND);
    if (text.isEmpty()) {
      boolean labels = dicom.attributes().text(DicomTag.SOP_CLASS).equals(LABEL_MAP_CLASS);
      return labels ? Kind.LABEL_MAP : dicom.bitsAllocated() == 1 ? Kind.BINARY : Kind.FRACTIONAL;
    }
    return switch (text) {
      case "BINARY" -> Kind.BINARY;
      case "FRACTIONAL" -> Kind.FRACTIONAL;
      case "LABELMAP" -> Kind.LABEL_MAP;
      default ->
          throw dicom.refusal(
              "the segmentation is of an unknown kind",
              "save it as a binary DICOM segmentation, for example with 3D Slicer");
    };
  }

  private static void checkBits(DicomFile dicom, Kind kind) throws VolumeFormatException {
    int bits = dicom.bitsAllocated();
    Set<Integer> allowed =
        switch (kind) {
          case BINARY -> Set.of(1, 8);
          case FRACTIONAL -> Set.of(8);
          case LABEL_MAP -> Set.of(8, 16);
        };
    boolean packed = bits == 1;
    boolean readable =
        !packed
            || (dicom.syntax().coding() == Coding.PLAIN
                && dicom.order() == ByteOrder.LITTLE_ENDIAN);
    if (!allowed.contains(bits) || dicom.samples() != 1 || !readable) {
      throw dicom.refusal(
          "the "
              + kind.text()
              + " segmentation has "
              + bits
              + " bits a pixel, encoded as "
              + dicom.syntax().name()
              + ", which cannot be read",
          DicomFile.CONVERT);
    }
  }

  private static LabelTable table(DicomFile dicom) throws VolumeFormatException {
    Map<Long, Label> labels = new TreeMap<>();
    for (DicomDataSet segment : dicom.attributes().items(DicomTag.SEGMENT_SEQUENCE)) {
      int number = segment.number(DicomTag.SEGMENT_NUMBER, 0);
      if (number > 0) {
        String name = decoded(dicom, segment.text(DicomTag.SEGMENT_LABEL));
        labels.put((long) number, new Label(name, rgb(segment)));
      }
    }
    if (labels.isEmpty()) {
      throw dicom.refusal("the segmentation describes no segment", "save it again");
    }
    return new LabelTable(labels, true);
  }

  private static int rgb(DicomDataSet segment) {
    int[] lab = segment.numbers(DicomTag.SEGMENT_COLOUR);
    return lab.length == 3 ? LabColour.toRgb(lab) : WITHOUT_COLOUR;
  }

  /** Returns a text that was stored byte by byte, in the character set of the file. */
  private static String decoded(DicomFile dicom, String text) {
    String set = dicom.attributes().text(DicomTag.CHARACTER_SET).split("\\\\", 2)[0].strip();
    String java = CHARACTER_SETS.getOrDefault(set, "ISO-8859-1");
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    return Charset.isSupported(java) ? new String(bytes, Charset.forName(java)) : text;
  }

  private static List<Integer> segmentOfFrame(DicomFile dicom, Kind kind, LabelTable table)
      throws VolumeFormatException {
    int count = dicom.frameCount();
    List<Integer> segments = new ArrayList<>(count);
    for (FrameAttributes frame : FrameAttributes.of(dicom, count)) {
      int only =
          table.labels().size() == 1 ? table.labels().keySet().iterator().next().intValue() : 0;
      int segment =
          kind == Kind.LABEL_MAP
              ? 0
              : frame.number(
                  DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE, DicomTag.REFERENCED_SEGMENT, only);
      if (kind != Kind.LABEL_MAP && !table.labels().containsKey((long) segment)) {
        throw dicom.refusal(
            "a frame shows segment " + segment + ", which the file does not describe",
            "save the segmentation again");
      }
      segments.add(segment);
    }
    return segments;
  }

  /** Returns the names of segments that no frame shows; none in a label map. */
  List<String> namesWithoutFrame() {
    Set<Integer> shown = Set.copyOf(segmentOfFrame);
    return kind == Kind.LABEL_MAP
        ? List.of()
        : table.labels().entrySet().stream()
            .filter(entry -> !shown.contains(entry.getKey().intValue()))
            .map(entry -> entry.getValue().name())
            .toList();
  }
}
