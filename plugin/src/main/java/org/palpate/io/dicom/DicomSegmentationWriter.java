package org.palpate.io.dicom;

import java.io.IOException;
import java.io.OutputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.VoxelGrid;

/**
 * Writes the labels of a volume as a binary DICOM segmentation object. Identifiers are new, and all
 * attributes of a patient and a study are empty.
 *
 * <p>Source: DICOM PS3.3, A.51, C.7.6.16 and C.8.20.
 */
public final class DicomSegmentationWriter {
  private static final String SEGMENTATION_CLASS = "1.2.840.10008.5.1.4.1.1.66.4";
  private static final String IMPLEMENTATION = "2.25.214797586294583306236173418906462573120";
  private static final int DIMENSION_UID = 0x0020_9164;
  private static final int MAX_LABEL = 64;
  private static final int MAX_NUMBER = 65535;
  private static final long MAX_PIXEL_BYTES = 0xffff_fffeL;

  private final VolumeReader volume;
  private final VolumeHeader header;
  private final SegmentationFrames frames;
  private final String instance = newUid();
  private final String dimensions = newUid();

  private DicomSegmentationWriter(VolumeReader volume, SegmentationFrames frames) {
    this.volume = volume;
    header = volume.header();
    this.frames = frames;
  }

  /**
   * Writes a volume and returns the format in words. Reads the volume twice.
   *
   * @throws VolumeFormatException if it has no label table, no labelled voxel, or is too large
   */
  public static String write(VolumeReader volume, OutputStream out) throws IOException {
    if (volume.header().labels().map(table -> table.labels().isEmpty()).orElse(true)) {
      throw refusal(
          volume,
          "DICOM is written for segments only, and none is chosen",
          "choose segments with --segment, or name the file .nrrd or .nii.gz");
    }
    SegmentationFrames frames = SegmentationFrames.of(volume);
    if (frames.frames().isEmpty()) {
      throw refusal(volume, "no segment has a voxel to write", "choose other segments");
    }
    VoxelGrid grid = volume.header().grid();
    if (frames.bytes() > MAX_PIXEL_BYTES
        || frames.labels().size() > MAX_NUMBER
        || Math.max(grid.sizeX(), grid.sizeY()) > MAX_NUMBER) {
      throw refusal(volume, "the segments are too large for one DICOM file", "name the file .nrrd");
    }
    new DicomSegmentationWriter(volume, frames).write(out);
    return "DICOM segmentation, binary" + volume.header().axesTakenAs(CoordinateSystem.LPS);
  }

  private static VolumeFormatException refusal(VolumeReader volume, String what, String remedy) {
    return new VolumeFormatException(what, volume.sourceName(), remedy);
  }

  private void write(OutputStream out) throws IOException {
    out.write(new byte[DicomRecognizer.PREAMBLE]);
    out.write("DICM".getBytes(StandardCharsets.ISO_8859_1));
    byte[] meta =
        new DicomElements()
            .value(0x0002_0001, "OB", new byte[] {0, 1})
            .text(0x0002_0002, "UI", SEGMENTATION_CLASS)
            .text(0x0002_0003, "UI", instance)
            .text(DicomTag.TRANSFER_SYNTAX, "UI", TransferSyntax.EXPLICIT)
            .text(0x0002_0012, "UI", IMPLEMENTATION)
            .text(0x0002_0013, "SH", "PALPATE")
            .toBytes();
    out.write(new DicomElements().ints(0x0002_0000, meta.length).toBytes());
    out.write(meta);
    DicomElements elements = new DicomElements();
    addInstance(elements);
    addSeries(elements);
    addImage(elements);
    addSegments(elements);
    addPositions(elements);
    elements.head(DicomTag.PIXELS, "OB", frames.bytes());
    out.write(elements.toBytes());
    frames.writeBits(volume, out);
  }

  private void addInstance(DicomElements elements) {
    LocalDateTime now = LocalDateTime.now(ZoneId.systemDefault());
    elements
        .text(DicomTag.CHARACTER_SET, "CS", "ISO_IR 192")
        .text(DicomTag.IMAGE_TYPE, "CS", "DERIVED\\PRIMARY")
        .text(DicomTag.SOP_CLASS, "UI", SEGMENTATION_CLASS)
        .text(DicomTag.SOP_INSTANCE, "UI", instance)
        .text(0x0008_0020, "DA", "")
        .text(0x0008_0023, "DA", now.format(DateTimeFormatter.ofPattern("yyyyMMdd", Locale.ROOT)))
        .text(0x0008_0030, "TM", "")
        .text(0x0008_0033, "TM", now.format(DateTimeFormatter.ofPattern("HHmmss", Locale.ROOT)))
        .text(0x0008_0050, "SH", "")
        .text(DicomTag.MODALITY, "CS", "SEG")
        .text(0x0008_0070, "LO", "Palpate")
        .text(0x0008_0090, "PN", "")
        .text(0x0008_1090, "LO", "Palpate");
  }

  /** Adds an empty patient, and a study and a series of their own. */
  private void addSeries(DicomElements elements) {
    elements
        .text(0x0010_0010, "PN", "")
        .text(0x0010_0020, "LO", "")
        .text(0x0010_0030, "DA", "")
        .text(0x0010_0040, "CS", "")
        .text(0x0018_1000, "LO", "1")
        .text(0x0018_1020, "LO", "1")
        .text(0x0020_000D, "UI", newUid())
        .text(DicomTag.SERIES_UID, "UI", newUid())
        .text(0x0020_0010, "SH", "")
        .text(DicomTag.SERIES_NUMBER, "IS", "1")
        .text(DicomTag.INSTANCE_NUMBER, "IS", "1")
        .text(0x0020_0052, "UI", newUid())
        .text(0x0020_1040, "LO", "")
        .sequence(0x0020_9221, new DicomElements().text(DIMENSION_UID, "UI", dimensions))
        .sequence(
            0x0020_9222,
            dimension(DicomTag.REFERENCED_SEGMENT, DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE),
            dimension(DicomTag.POSITION, DicomTag.PLANE_POSITION_SEQUENCE));
  }

  private DicomElements dimension(int attribute, int group) {
    return new DicomElements()
        .text(DIMENSION_UID, "UI", dimensions)
        .tag(0x0020_9165, attribute)
        .tag(0x0020_9167, group);
  }

  private void addImage(DicomElements elements) {
    elements
        .shorts(DicomTag.SAMPLES, 1)
        .text(DicomTag.PHOTOMETRIC, "CS", "MONOCHROME2")
        .text(DicomTag.FRAMES, "IS", Integer.toString(frames.frames().size()))
        .shorts(DicomTag.ROWS, header.grid().sizeY())
        .shorts(DicomTag.COLUMNS, header.grid().sizeX())
        .shorts(DicomTag.BITS_ALLOCATED, 1)
        .shorts(DicomTag.BITS_STORED, 1)
        .shorts(DicomTag.HIGH_BIT, 0)
        .shorts(DicomTag.SIGNED, 0)
        .text(DicomTag.LOSSY, "CS", "00");
  }

  private void addSegments(DicomElements elements) {
    List<DicomElements> segments = new ArrayList<>();
    for (long value : frames.labels()) {
      Label label = header.labels().orElseThrow().labels().get(value);
      segments.add(segment(segments.size() + 1, label));
    }
    elements
        .text(DicomTag.SEGMENTATION_KIND, "CS", "BINARY")
        .sequence(DicomTag.SEGMENT_SEQUENCE, segments.toArray(DicomElements[]::new))
        .text(0x0062_0013, "CS", frames.overlap() ? "YES" : "NO")
        .text(0x0070_0080, "CS", "SEGMENTATION")
        .text(0x0070_0081, "LO", "")
        .text(0x0070_0084, "PN", "");
  }

  private static DicomElements segment(int number, Label label) {
    DicomElements segment =
        new DicomElements()
            .sequence(0x0062_0003, tissue())
            .shorts(DicomTag.SEGMENT_NUMBER, number)
            .text(DicomTag.SEGMENT_LABEL, "LO", shortName(label.name(), number))
            .text(0x0062_0008, "CS", "SEMIAUTOMATIC")
            .text(0x0062_0009, "LO", "Palpate");
    if (label.rgb() >= 0) {
      segment.shorts(DicomTag.SEGMENT_COLOUR, LabColour.ofRgb(label.rgb()));
    }
    return segment.sequence(0x0062_000F, tissue());
  }

  /** Returns the code of "tissue" in SNOMED CT, because nothing better is known of a segment. */
  private static DicomElements tissue() {
    return new DicomElements()
        .text(0x0008_0100, "SH", "85756007")
        .text(0x0008_0102, "SH", "SCT")
        .text(0x0008_0104, "LO", "Tissue");
  }

  private static String shortName(String name, int number) {
    String clean = name.replace('\\', '/').replaceAll("\\p{Cntrl}", "?").strip();
    int count = Math.min(MAX_LABEL, clean.codePointCount(0, clean.length()));
    String kept = clean.substring(0, clean.offsetByCodePoints(0, count));
    return kept.isEmpty() ? "segment " + number : kept;
  }

  private void addPositions(DicomElements elements) {
    VoxelGrid grid = header.grid();
    Vec3 x = patient(grid.gridMmToWorld().axisX());
    Vec3 y = patient(grid.gridMmToWorld().axisY());
    String axes = decimals(x.x, x.y, x.z, y.x, y.y, y.z);
    String depth = decimals(grid.spacingMm().z);
    DicomElements measures =
        new DicomElements()
            .text(DicomTag.SLICE_THICKNESS, "DS", depth)
            .text(DicomTag.SLICE_SPACING, "DS", depth)
            .text(DicomTag.PIXEL_SPACING, "DS", decimals(grid.spacingMm().y, grid.spacingMm().x));
    elements.sequence(
        DicomTag.SHARED_GROUPS,
        new DicomElements()
            .sequence(
                DicomTag.PLANE_ORIENTATION_SEQUENCE,
                new DicomElements().text(DicomTag.ORIENTATION, "DS", axes))
            .sequence(DicomTag.PIXEL_MEASURES_SEQUENCE, measures));
    elements.sequence(
        DicomTag.FRAME_GROUPS,
        frames.frames().stream().map(this::frameGroups).toArray(DicomElements[]::new));
  }

  private DicomElements frameGroups(SegmentationFrames.Frame frame) {
    Vec3 centre = new Vec3(0.5, 0.5, frame.slice() + 0.5);
    Vec3 at = patient(header.grid().gridToWorld(centre, centre));
    return new DicomElements()
        .sequence(
            DicomTag.FRAME_CONTENT_SEQUENCE,
            new DicomElements().ints(0x0020_9157, frame.segment(), frame.slice() + 1))
        .sequence(
            DicomTag.PLANE_POSITION_SEQUENCE,
            new DicomElements().text(DicomTag.POSITION, "DS", decimals(at.x, at.y, at.z)))
        .sequence(
            DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE,
            new DicomElements().shorts(DicomTag.REFERENCED_SEGMENT, frame.segment()));
  }

  /** Returns a vector of the world in LPS. */
  private Vec3 patient(Vec3 world) {
    return switch (header.coordinateSystem()) {
      case LPS, UNKNOWN -> world;
      case RAS -> new Vec3(-world.x, -world.y, world.z);
      case LAS -> new Vec3(world.x, -world.y, world.z);
    };
  }

  private static String decimals(double... numbers) {
    List<String> words = new ArrayList<>();
    for (double number : numbers) {
      words.add(DecimalString.of(number));
    }
    return String.join("\\", words);
  }

  /** Returns a new identifier made from a random number, as PS3.5 annex B.2 allows. */
  private static String newUid() {
    UUID random = UUID.randomUUID();
    BigInteger high = new BigInteger(Long.toUnsignedString(random.getMostSignificantBits()));
    BigInteger low = new BigInteger(Long.toUnsignedString(random.getLeastSignificantBits()));
    return "2.25." + high.shiftLeft(64).or(low);
  }
}
