package org.palpate.io.dicom;

import java.util.Set;

/**
 * The DICOM attributes that are read, with the group in the high 16 bits. None names a patient, and
 * no other attribute is read.
 *
 * <p>Source: DICOM PS3.6.
 */
final class DicomTag {
  static final int TRANSFER_SYNTAX = 0x0002_0010;
  static final int CHARACTER_SET = 0x0008_0005;
  static final int IMAGE_TYPE = 0x0008_0008;
  static final int SOP_CLASS = 0x0008_0016;
  static final int SOP_INSTANCE = 0x0008_0018;
  static final int MODALITY = 0x0008_0060;
  static final int ECHO_TIME = 0x0018_0081;
  static final int ECHO_NUMBER = 0x0018_0086;
  static final int SLICE_SPACING = 0x0018_0088;
  static final int SLICE_THICKNESS = 0x0018_0050;
  static final int TRIGGER_TIME = 0x0018_1060;
  static final int KERNEL = 0x0018_1210;
  static final int DIFFUSION_B = 0x0018_9087;
  static final int EFFECTIVE_ECHO_TIME = 0x0018_9082;
  static final int MR_DIFFUSION_SEQUENCE = 0x0018_9117;
  static final int MR_ECHO_SEQUENCE = 0x0018_9114;
  static final int CARDIAC_SEQUENCE = 0x0018_9118;
  static final int SERIES_UID = 0x0020_000E;
  static final int SERIES_NUMBER = 0x0020_0011;
  static final int ACQUISITION_NUMBER = 0x0020_0012;
  static final int INSTANCE_NUMBER = 0x0020_0013;
  static final int POSITION = 0x0020_0032;
  static final int ORIENTATION = 0x0020_0037;
  static final int TEMPORAL_POSITION = 0x0020_0100;
  static final int STACK_ID = 0x0020_9056;
  static final int FRAME_CONTENT_SEQUENCE = 0x0020_9111;
  static final int PLANE_POSITION_SEQUENCE = 0x0020_9113;
  static final int PLANE_ORIENTATION_SEQUENCE = 0x0020_9116;
  static final int TEMPORAL_INDEX = 0x0020_9128;
  static final int CARDIAC_DELAY = 0x0020_9153;
  static final int SAMPLES = 0x0028_0002;
  static final int PHOTOMETRIC = 0x0028_0004;
  static final int PLANAR = 0x0028_0006;
  static final int FRAMES = 0x0028_0008;
  static final int ROWS = 0x0028_0010;
  static final int COLUMNS = 0x0028_0011;
  static final int PIXEL_SPACING = 0x0028_0030;
  static final int BITS_ALLOCATED = 0x0028_0100;
  static final int BITS_STORED = 0x0028_0101;
  static final int HIGH_BIT = 0x0028_0102;
  static final int SIGNED = 0x0028_0103;
  static final int PADDING = 0x0028_0120;
  static final int INTERCEPT = 0x0028_1052;
  static final int SLOPE = 0x0028_1053;
  static final int LOSSY = 0x0028_2110;
  static final int MODALITY_TABLE_SEQUENCE = 0x0028_3000;
  static final int PIXEL_MEASURES_SEQUENCE = 0x0028_9110;
  static final int VALUE_SEQUENCE = 0x0028_9145;
  static final int SEGMENTATION_KIND = 0x0062_0001;
  static final int SEGMENT_SEQUENCE = 0x0062_0002;
  static final int SEGMENT_NUMBER = 0x0062_0004;
  static final int SEGMENT_LABEL = 0x0062_0005;
  static final int SEGMENT_IDENTIFICATION_SEQUENCE = 0x0062_000A;
  static final int REFERENCED_SEGMENT = 0x0062_000B;
  static final int SEGMENT_COLOUR = 0x0062_000D;
  static final int MOST_FRACTION = 0x0062_000E;
  static final int DOSE_UNITS = 0x3004_0002;
  static final int FRAME_OFFSETS = 0x3004_000C;
  static final int DOSE_SCALING = 0x3004_000E;
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
          MR_DIFFUSION_SEQUENCE,
          MR_ECHO_SEQUENCE,
          CARDIAC_SEQUENCE,
          FRAME_CONTENT_SEQUENCE,
          PLANE_POSITION_SEQUENCE,
          PLANE_ORIENTATION_SEQUENCE,
          MODALITY_TABLE_SEQUENCE,
          PIXEL_MEASURES_SEQUENCE,
          VALUE_SEQUENCE,
          SEGMENT_SEQUENCE,
          SEGMENT_IDENTIFICATION_SEQUENCE,
          SHARED_GROUPS,
          FRAME_GROUPS);

  /** Attributes whose value is one or several numbers of 16 or 32 bits. */
  static final Set<Integer> NUMBERS =
      Set.of(
          TEMPORAL_INDEX,
          SAMPLES,
          PLANAR,
          ROWS,
          COLUMNS,
          BITS_ALLOCATED,
          BITS_STORED,
          HIGH_BIT,
          SIGNED,
          PADDING,
          SEGMENT_NUMBER,
          REFERENCED_SEGMENT,
          SEGMENT_COLOUR,
          MOST_FRACTION);

  /** Attributes whose value is one number of 64 bits, floating-point. */
  static final Set<Integer> DOUBLES = Set.of(EFFECTIVE_ECHO_TIME, DIFFUSION_B, CARDIAC_DELAY);

  static final Set<Integer> TEXTS =
      Set.of(
          TRANSFER_SYNTAX,
          CHARACTER_SET,
          IMAGE_TYPE,
          SOP_CLASS,
          SOP_INSTANCE,
          MODALITY,
          ECHO_TIME,
          ECHO_NUMBER,
          SLICE_SPACING,
          SLICE_THICKNESS,
          TRIGGER_TIME,
          KERNEL,
          SERIES_UID,
          SERIES_NUMBER,
          ACQUISITION_NUMBER,
          INSTANCE_NUMBER,
          POSITION,
          ORIENTATION,
          TEMPORAL_POSITION,
          STACK_ID,
          PHOTOMETRIC,
          FRAMES,
          PIXEL_SPACING,
          INTERCEPT,
          SLOPE,
          LOSSY,
          SEGMENTATION_KIND,
          SEGMENT_LABEL,
          DOSE_UNITS,
          FRAME_OFFSETS,
          DOSE_SCALING);

  private DicomTag() {}
}
