package org.palpate.io.dicom;

/**
 * Converts colours between sRGB and the CIELab of DICOM, of 16 bits a part, for the white of D50.
 *
 * <p>Source: DICOM PS3.3, C.10.7.1.1; IEC 61966-2-1; the matrices are those of sRGB adapted to D50
 * by Bradford's method.
 */
final class LabColour {
  private static final double[] WHITE = {0.96422, 1, 0.82521};
  private static final double[][] TO_XYZ = {
    {0.4360747, 0.3850649, 0.1430804},
    {0.2225045, 0.7168786, 0.0606169},
    {0.0139322, 0.0971045, 0.7141733}
  };
  private static final double[][] TO_RGB = {
    {3.1338561, -1.6168667, -0.4906146},
    {-0.9787684, 1.9161415, 0.0334540},
    {0.0719453, -0.2289914, 1.4052427}
  };
  private static final double DELTA = 6.0 / 29;
  private static final double MOST = 65535;

  private LabColour() {}

  /** Returns the colour, 0xRRGGBB, of three parts of 16 bits. */
  static int toRgb(int[] parts) {
    double lightness = parts[0] / MOST * 100;
    double fy = (lightness + 16) / 116;
    double fx = fy + (parts[1] / MOST * 255 - 128) / 500;
    double fz = fy - (parts[2] / MOST * 255 - 128) / 200;
    double[] xyz = {WHITE[0] * cubed(fx), WHITE[1] * cubed(fy), WHITE[2] * cubed(fz)};
    int rgb = 0;
    for (double[] row : TO_RGB) {
      double linear = row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2];
      double value =
          linear <= 0.0031308 ? 12.92 * linear : 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
      rgb = rgb << 8 | (int) Math.rint(Math.max(0, Math.min(1, value)) * 255);
    }
    return rgb;
  }

  /** Returns the three parts of 16 bits of a colour, 0xRRGGBB. */
  static int[] ofRgb(int rgb) {
    double[] linear = new double[3];
    for (int n = 0; n < 3; n++) {
      double value = (rgb >> (16 - 8 * n) & 0xff) / 255.0;
      linear[n] = value <= 0.04045 ? value / 12.92 : StrictMath.pow((value + 0.055) / 1.055, 2.4);
    }
    double[] f = new double[3];
    for (int n = 0; n < 3; n++) {
      double[] row = TO_XYZ[n];
      f[n] = root((row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2]) / WHITE[n]);
    }
    return new int[] {
      part((116 * f[1] - 16) / 100),
      part((500 * (f[0] - f[1]) + 128) / 255),
      part((200 * (f[1] - f[2]) + 128) / 255)
    };
  }

  private static int part(double share) {
    return (int) Math.rint(Math.max(0, Math.min(1, share)) * MOST);
  }

  private static double cubed(double f) {
    return f > DELTA ? f * f * f : 3 * DELTA * DELTA * (f - 4.0 / 29);
  }

  private static double root(double t) {
    return t > DELTA * DELTA * DELTA ? StrictMath.cbrt(t) : t / (3 * DELTA * DELTA) + 4.0 / 29;
  }
}
