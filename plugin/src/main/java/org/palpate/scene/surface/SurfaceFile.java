package org.palpate.scene.surface;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Writes surfaces to binary STL or PLY files in world mm. Triangles are counter-clockwise seen from
 * outside, even if the transform mirrors.
 */
public final class SurfaceFile {
  private static final int STL_HEADER_BYTES = 80;
  private static final int STL_TRIANGLE_BYTES = 50;
  private static final int PLY_VERTEX_BYTES = 24;
  private static final int PLY_FACE_BYTES = 13;

  private SurfaceFile() {}

  /** Whether a file's name ends with .stl or .ply. */
  public static boolean isSurfaceName(Path file) {
    return isStl(file) || isPly(file);
  }

  /**
   * Writes a surface as binary STL, or as binary little-endian PLY with normals.
   *
   * @param gridMmToWorld pose of the surface
   * @param space name of the world's axes, LPS or RAS, which 3D Slicer reads; empty for none
   */
  public static void write(
      WeldedSurface surface,
      RigidTransform gridMmToWorld,
      String space,
      boolean stl,
      OutputStream out)
      throws IOException {
    if (stl) {
      writeStl(surface, gridMmToWorld, space, out);
    } else {
      writePly(surface, gridMmToWorld, space, out);
    }
  }

  /** Returns the comment of a file in a space; empty for axes without names. */
  public static String comment(String space) {
    return "Palpate surface, mm" + (space.isEmpty() ? "" : "; SPACE=" + space);
  }

  /** Whether a file's name ends with .stl. */
  public static boolean isStl(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".stl");
  }

  private static boolean isPly(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".ply");
  }

  private static void writeStl(
      WeldedSurface surface, RigidTransform gridMmToWorld, String space, OutputStream out)
      throws IOException {
    byte[] header = new byte[STL_HEADER_BYTES];
    byte[] title = comment(space).getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(title, 0, header, 0, title.length);
    out.write(header);
    byte[] count = new byte[Integer.BYTES];
    little(count).putInt(surface.triangleCount());
    out.write(count);
    float[] world = toWorld(surface.positionsMm(), gridMmToWorld);
    boolean mirrored = gridMmToWorld.isMirrored();
    byte[] bytes = new byte[STL_TRIANGLE_BYTES];
    ByteBuffer record = little(bytes);
    int[] corners = surface.triangles();
    for (int t = 0; t < corners.length; t += 3) {
      int second = mirrored ? 2 : 1;
      record.clear();
      putStl(record, world, 3 * corners[t], 3 * corners[t + second], 3 * corners[t + 3 - second]);
      out.write(bytes);
    }
  }

  private static void putStl(ByteBuffer record, float[] world, int a, int b, int c) {
    Vec3 u =
        new Vec3(world[b] - world[a], world[b + 1] - world[a + 1], world[b + 2] - world[a + 2]);
    Vec3 v =
        new Vec3(world[c] - world[a], world[c + 1] - world[a + 1], world[c + 2] - world[a + 2]);
    Vec3 normal = u.cross(v, new Vec3());
    double length = normal.length();
    normal.mul(length > 0 ? 1 / length : 0, normal);
    record.putFloat((float) normal.x).putFloat((float) normal.y).putFloat((float) normal.z);
    for (int corner : new int[] {a, b, c}) {
      record.putFloat(world[corner]).putFloat(world[corner + 1]).putFloat(world[corner + 2]);
    }
    record.putShort((short) 0);
  }

  private static void writePly(
      WeldedSurface surface, RigidTransform gridMmToWorld, String space, OutputStream out)
      throws IOException {
    out.write(plyHeader(surface, space).getBytes(StandardCharsets.US_ASCII));
    float[] world = toWorld(surface.positionsMm(), gridMmToWorld);
    byte[] vertexBytes = new byte[PLY_VERTEX_BYTES];
    ByteBuffer vertex = little(vertexBytes);
    Vec3 normal = new Vec3();
    for (int i = 0; i < surface.vertexCount(); i++) {
      short[] packed = surface.normals();
      normal.set(packed[4 * i], packed[4 * i + 1], packed[4 * i + 2]);
      gridMmToWorld.rotate(normal.mul(1.0 / SurfaceBrick.FULL_SCALE, normal), normal);
      vertex.clear();
      vertex.putFloat(world[3 * i]).putFloat(world[3 * i + 1]).putFloat(world[3 * i + 2]);
      vertex.putFloat((float) normal.x).putFloat((float) normal.y).putFloat((float) normal.z);
      out.write(vertexBytes);
    }
    byte[] faceBytes = new byte[PLY_FACE_BYTES];
    ByteBuffer face = little(faceBytes);
    int second = gridMmToWorld.isMirrored() ? 2 : 1;
    int[] corners = surface.triangles();
    for (int t = 0; t < corners.length; t += 3) {
      face.clear();
      face.put((byte) 3).putInt(corners[t]).putInt(corners[t + second]);
      face.putInt(corners[t + 3 - second]);
      out.write(faceBytes);
    }
  }

  private static String plyHeader(WeldedSurface surface, String space) {
    return "ply\nformat binary_little_endian 1.0\ncomment "
        + comment(space)
        + "\nelement vertex "
        + surface.vertexCount()
        + "\nproperty float x\nproperty float y\nproperty float z"
        + "\nproperty float nx\nproperty float ny\nproperty float nz\nelement face "
        + surface.triangleCount()
        + "\nproperty list uchar int vertex_indices\nend_header\n";
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static float[] toWorld(float[] positionsMm, RigidTransform gridMmToWorld) {
    float[] world = new float[positionsMm.length];
    Vec3 point = new Vec3();
    for (int i = 0; i < world.length; i += 3) {
      point.set(positionsMm[i], positionsMm[i + 1], positionsMm[i + 2]);
      gridMmToWorld.transform(point, point);
      world[i] = (float) point.x;
      world[i + 1] = (float) point.y;
      world[i + 2] = (float) point.z;
    }
    return world;
  }
}
