package org.palpate.endtoend;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.ToIntFunction;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;

/** Makes small test files. */
final class TestFiles {
  private TestFiles() {}

  /** Writes an NRRD file of bytes, x fastest, spacing 1, 1, 2. */
  static Path nrrd(Path file, int edge, ToIntFunction<int[]> value) throws IOException {
    return Files.write(file, nrrdBytes(edge, value));
  }

  /** Returns the bytes of such a file. */
  static byte[] nrrdBytes(int edge, ToIntFunction<int[]> value) {
    return nrrdBytes(
        edge,
        "space: left-posterior-superior\n"
            + "space directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (-10,-20,30)",
        value);
  }

  /** Returns the bytes of an NRRD file, x fastest, whose header places it in a world. */
  static byte[] nrrdBytes(int edge, String place, ToIntFunction<int[]> value) {
    byte[] header =
        ("NRRD0004\ntype: uint8\ndimension: 3\nsizes: "
                + (edge + " " + edge + " " + edge)
                + "\n"
                + place
                + "\nencoding: raw\n\n")
            .getBytes(StandardCharsets.US_ASCII);
    byte[] bytes = java.util.Arrays.copyOf(header, header.length + edge * edge * edge);
    int at = header.length;
    for (int k = 0; k < edge; k++) {
      for (int j = 0; j < edge; j++) {
        for (int i = 0; i < edge; i++) {
          bytes[at++] = (byte) value.applyAsInt(new int[] {i, j, k});
        }
      }
    }
    return bytes;
  }

  /** Writes a trajectory of pushes, turns and jumps about a centre, through a span in mm. */
  static Path toolTrajectory(
      Path file, SplittableRandom random, int frames, Vec3 centre, double spanMm)
      throws IOException {
    StringBuilder text = new StringBuilder("t_ms,x,y,z,qz,qw,qx,qy\n");
    Vec3 at = new Vec3(0, 0, 0.4 * spanMm);
    Quaternion q = new Quaternion();
    Quaternion turn = new Quaternion();
    for (int frame = 0; frame < frames; frame++) {
      boolean jumps = frame % 60 == 59;
      at.add(RandomGeometry.vector(random, jumps ? spanMm / 3 : 0.5), at);
      at.mul(0.98, at);
      turn.setRotationVector(RandomGeometry.vector(random, jumps ? 2 : 0.03)).multiply(q, q);
      q.normalize();
      text.append(frame).append(',').append(at.x + centre.x).append(',').append(at.y + centre.y);
      text.append(',').append(at.z + centre.z).append(',').append(q.z).append(',').append(q.w);
      text.append(',').append(q.x).append(',').append(q.y).append('\n');
    }
    return Files.writeString(file, text);
  }

  /** Writes a seeded random trajectory through a cube, with some long steps; the edge is in mm. */
  static Path trajectory(Path file, int frames, double edgeMm, long seed) throws IOException {
    SplittableRandom random = new SplittableRandom(seed);
    StringBuilder text = new StringBuilder("t_ms,x,y,z\n");
    double[] p = {0.5 * edgeMm, 0.5 * edgeMm, 1.1 * edgeMm};
    for (int frame = 0; frame < frames; frame++) {
      double step = frame % 50 == 49 ? edgeMm / 4 : 0.4;
      for (int axis = 0; axis < 3; axis++) {
        double pull = (0.5 * edgeMm - p[axis]) * 0.02;
        p[axis] += pull + step * (2 * random.nextDouble() - 1);
      }
      text.append(String.format(Locale.ROOT, "%d,%s,%s,%s%n", frame, p[0], p[1], p[2]));
    }
    return Files.writeString(file, text.toString().replace("\r", ""));
  }
}
