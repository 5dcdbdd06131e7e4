package org.palpate.io.dicom;

import java.util.Set;

/**
 * The DICOM attributes that are read, with the group in the high 16 bits. None identifies a
 * patient, and no other attribute is read.
 *
 * <p>Source: DICOM PS3.6.
 */
final class DicomTag {
  static final int TRANSFER_SYNTAX = 0x0002_0010;
  static final int MODALITY = 0x0008_0060;
  static final int SLICE_SPACING = 0x0018_0088;
  static final int SERIES_UID = 0x0020_000E;
  static final int SERIES_NUMBER = 0x0020_0011;
  static final int POSITION = 0x0020_0032;
  static final int ORIENTATION = 0x0020_0037;
  static final int PLANE_POSITION_SEQUENCE = 0x0020_9113;
  static final int PLANE_ORIENTATION_SEQUENCE = 0x0020_9116;
  static final int SAMPLES = 0x0028_0002;
  static final int PHOTOMETRIC = 0x0028_0004;
  static final int FRAMES = 0x0028_0008;
  static final int ROWS = 0x0028_0010;
  static final int COLUMNS = 0x0028_0011;
  static final int PIXEL_SPACING = 0x0028_0030;
  static final int BITS_ALLOCATED = 0x0028_0100;
  static final int BITS_STORED = 0x0028_0101;
  static final int HIGH_BIT = 0x0028_0102;
  static final int SIGNED = 0x0028_0103;
  static final int INTERCEPT = 0x0028_1052;
  static final int SLOPE = 0x0028_1053;
  static final int PIXEL_MEASURES_SEQUENCE = 0x0028_9110;
  static final int VALUE_SEQUENCE = 0x0028_9145;
  static final int SHARED_GROUPS = 0x5200_9229;
  static final int FRAME_GROUPS = 0x5200_9230;
  static final int FLOAT_PIXELS = 0x7FE0_0008;
  static final int DOUBLE_PIXELS = 0x7FE0_0009;
  static final int PIXELS = 0x7FE0_0010;

  static final int ITEM = 0xFFFE_E000;
  static final int ITEM_END = 0xFFFE_E00D;
  static final int SEQUENCE_END = 0xFFFE_E0DD;

  static final Set<Integer> SEQUENCES =
      Set.of(
          PLANE_POSITION_SEQUENCE,
          PLANE_ORIENTATION_SEQUENCE,
          PIXEL_MEASURES_SEQUENCE,
          VALUE_SEQUENCE,
          SHARED_GROUPS,
          FRAME_GROUPS);

  static final Set<Integer> VALUES =
      Set.of(
          TRANSFER_SYNTAX,
          MODALITY,
          SLICE_SPACING,
          SERIES_UID,
          SERIES_NUMBER,
          POSITION,
          ORIENTATION,
          SAMPLES,
          PHOTOMETRIC,
          FRAMES,
          ROWS,
          COLUMNS,
          PIXEL_SPACING,
          BITS_ALLOCATED,
          BITS_STORED,
          HIGH_BIT,
          SIGNED,
          INTERCEPT,
          SLOPE);

  private DicomTag() {}
}
