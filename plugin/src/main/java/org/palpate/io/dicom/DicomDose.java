package org.palpate.io.dicom;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Places the frames of a dose grid (RTDOSE) and scales them.
 *
 * <p>Source: DICOM PS3.3, C.8.8.3.
 */
final class DicomDose {
  private static final double SAME_MM = 1e-3;

  private DicomDose() {}

  /** Whether a file is a dose grid. */
  static boolean isDose(DicomFile dicom) {
    return dicom.attributes().text(DicomTag.MODALITY).equals("RTDOSE");
  }

  /** Returns a sentence about the unit of the values. */
  static String note(DicomFile dicom) {
    return dicom.attributes().text(DicomTag.DOSE_UNITS).equals("GY")
        ? "the values are a dose in Gy"
        : "the values are a dose relative to a reference, in no unit";
  }

  /** Returns the frames of a dose grid at the offsets that the file lists. */
  static List<DicomFrame> frames(DicomFile dicom, int count) throws VolumeFormatException {
    Scaling scaling = new Scaling(scaling(dicom), 0);
    double[] position = dicom.attributes().decimals(DicomTag.POSITION, 3);
    double[] axes = dicom.attributes().decimals(DicomTag.ORIENTATION, 6);
    double[] offsets = dicom.attributes().decimals(DicomTag.FRAME_OFFSETS);
    if (position == null || axes == null || (count > 1 && offsets.length != count)) {
      throw dicom.refusal(
          "the dose grid has "
              + count
              + " frames but "
              + offsets.length
              + " offsets (GridFrameOffsetVector), or no position",
          "export the dose again");
    }
    List<DicomFrame> frames = new ArrayList<>(count);
    List<FrameAttributes> attributes = FrameAttributes.of(dicom, count);
    ImagePlane first = attributes.get(0).plane(position, axes);
    Vec3 direction = direction(first, offsets);
    for (int n = 0; n < count; n++) {
      double offset = count == 1 ? 0 : offsets[n] - offsets[0];
      Vec3 moved = direction.mul(offset, new Vec3());
      if (!moved.isFinite()) {
        throw dicom.refusal("an offset of the dose grid is no number", "export the dose again");
      }
      Vec3 at = moved.add(first.position(), moved);
      frames.add(new DicomFrame(dicom, n, Optional.of(first.at(at)), scaling, attributes.get(n)));
    }
    return frames;
  }

  /** Returns the direction of the offsets. Offsets that begin with the position's z are along z. */
  private static Vec3 direction(ImagePlane first, double[] offsets) {
    boolean absolute =
        offsets.length > 0
            && offsets[0] != 0
            && Math.abs(offsets[0] - first.position().z) <= SAME_MM;
    return absolute ? new Vec3(0, 0, 1) : first.normal();
  }

  private static double scaling(DicomFile dicom) throws VolumeFormatException {
    double[] scaling = dicom.attributes().decimals(DicomTag.DOSE_SCALING, 1);
    if (scaling == null || !(scaling[0] > 0) || Double.isInfinite(scaling[0])) {
      throw dicom.refusal(
          "the dose grid has no DoseGridScaling, so its values have no unit",
          "export the dose again");
    }
    return scaling[0];
  }
}
