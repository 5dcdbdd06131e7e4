package org.palpate.io.scene;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;

/**
 * Formats poses as ITK transform files, which 3D Slicer and SimpleITK read: one affine transform
 * from rest to present, in LPS millimetres, with the centre at the origin.
 *
 * <p>Reference: itk::TxtTransformIO of ITK 5, {@code #Insight Transform File V1.0}.
 */
public final class TransformWriter {
  private TransformWriter() {}

  /**
   * Returns the text of a transform file.
   *
   * @param pose from rest to present, world mm
   * @param world the directions of the world axes; unknown ones are taken as LPS
   */
  public static String text(Pose pose, CoordinateSystem world) {
    AffineMap m = new AffineMap().set(pose);
    Vec3 s = AxisSigns.between(world, CoordinateSystem.LPS).orElse(new Vec3(1, 1, 1));
    double[] parameters = {
      m.mXX,
      s.x * s.y * m.mXY,
      s.x * s.z * m.mXZ,
      s.x * s.y * m.mYX,
      m.mYY,
      s.y * s.z * m.mYZ,
      s.x * s.z * m.mZX,
      s.y * s.z * m.mZY,
      m.mZZ,
      s.x * m.offsetX,
      s.y * m.offsetY,
      s.z * m.offsetZ
    };
    StringBuilder text = new StringBuilder("#Insight Transform File V1.0\n#Transform 0\n");
    text.append("Transform: AffineTransform_double_3_3\nParameters:");
    for (double parameter : parameters) {
      text.append(' ').append(NumberText.text(parameter + 0.0));
    }
    return text.append("\nFixedParameters: 0 0 0\n").toString();
  }
}
