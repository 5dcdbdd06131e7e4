package org.palpate.scene.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class SurfaceFileTest {
  private static final RigidTransform MIRRORED =
      new RigidTransform(
          new Vec3(-1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(5, 6, 7));

  private final WeldedSurface sphere =
      Shapes.surface(SurfaceSource.ofBits(Shapes.sphere(20, 7), Shapes.UNIT));

  @Test
  void stlContainsEveryTriangleWithItsNormalOutwardEvenIfMirrored() throws Exception {
    for (RigidTransform place : new RigidTransform[] {RigidTransform.identity(), MIRRORED}) {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      SurfaceFile.write(sphere, place, "LPS", true, out);
      ByteBuffer stl = ByteBuffer.wrap(out.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
      assertEquals(84 + 50 * sphere.triangleCount(), stl.capacity());
      assertEquals(sphere.triangleCount(), stl.getInt(80));
      String header = new String(out.toByteArray(), 0, 80, StandardCharsets.US_ASCII);
      assertEquals("Palpate surface, mm; SPACE=LPS", header.replace("\0", ""));
      Vec3 middle = place.transform(new Vec3(10, 10, 10), new Vec3());
      assertEquals(SurfaceMeasures.of(sphere).volumeMm3(), stlVolume(stl, middle), 0.1);
    }
  }

  @Test
  void plyContainsEveryVertexOnceWithItsNormalOutward() throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    SurfaceFile.write(sphere, MIRRORED, "RAS", false, out);
    byte[] bytes = out.toByteArray();
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int body = text.indexOf("end_header\n") + "end_header\n".length();
    assertTrue(text.contains("\ncomment Palpate surface, mm; SPACE=RAS\n"));
    assertTrue(text.contains("element vertex " + sphere.vertexCount() + "\n"));
    assertTrue(text.contains("element face " + sphere.triangleCount() + "\n"));
    assertEquals(body + 24 * sphere.vertexCount() + 13 * sphere.triangleCount(), bytes.length);
    ByteBuffer ply = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    for (int v = 0; v < sphere.vertexCount(); v++) {
      int at = body + 24 * v;
      double along =
          (ply.getFloat(at) - (5 - 10)) * ply.getFloat(at + 12)
              + (ply.getFloat(at + 4) - 16) * ply.getFloat(at + 16)
              + (ply.getFloat(at + 8) - 17) * ply.getFloat(at + 20);
      assertEquals(7, along, 1.0);
    }
  }

  @Test
  void objHasAGroupAndAColourForEachSurfaceWithTheOutsideCounterClockwise() throws Exception {
    List<ObjFile.Group> groups =
        List.of(
            new ObjFile.Group("left lung", 0xff8000, sphere),
            new ObjFile.Group("bone", 0x0000ff, sphere));
    for (RigidTransform place : new RigidTransform[] {RigidTransform.identity(), MIRRORED}) {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      ObjFile.write(groups, place, SurfaceFile.comment("LPS"), "a.mtl", out);
      List<String> lines = out.toString(StandardCharsets.UTF_8).lines().toList();
      assertEquals(
          List.of("# Palpate surface, mm; SPACE=LPS", "mtllib a.mtl", "g left_lung"),
          lines.subList(0, 3));
      assertTrue(lines.contains("g bone") && lines.contains("usemtl segment2"));
      Vec3 middle = place.transform(new Vec3(10, 10, 10), new Vec3());
      assertEquals(2 * SurfaceMeasures.of(sphere).volumeMm3(), objVolume(lines, middle), 0.1);
    }
    assertEquals(
        "# left_lung\nnewmtl segment1\nKd 1 0.5020 0\n# bone\nnewmtl segment2\nKd 0 0 1\n",
        ObjFile.materials(groups));
  }

  private static double objVolume(List<String> lines, Vec3 middle) {
    List<Vec3> vertices = new java.util.ArrayList<>();
    double sum = 0;
    for (String line : lines) {
      String[] words = line.split(" ", -1);
      if (words[0].equals("v")) {
        Vec3 point = new Vec3(number(words[1]), number(words[2]), number(words[3]));
        vertices.add(point.sub(middle, new Vec3()));
      } else if (words[0].equals("f")) {
        Vec3 a = corner(vertices, words[1]);
        Vec3 b = corner(vertices, words[2]);
        Vec3 c = corner(vertices, words[3]);
        sum +=
            (a.x * (b.y * c.z - b.z * c.y)
                    + a.y * (b.z * c.x - b.x * c.z)
                    + a.z * (b.x * c.y - b.y * c.x))
                / 6;
      }
    }
    return sum;
  }

  private static double number(String word) {
    return Double.parseDouble(word);
  }

  private static Vec3 corner(List<Vec3> vertices, String word) {
    return vertices.get(Integer.parseInt(word.substring(0, word.indexOf('/'))) - 1);
  }

  @Test
  void combinedSurfacesKeepTheirTriangles() {
    WeldedSurface two = WeldedSurface.together(List.of(sphere, sphere));
    assertEquals(2 * sphere.triangleCount(), two.triangleCount());
    assertEquals(
        2 * SurfaceMeasures.of(sphere).volumeMm3(), SurfaceMeasures.of(two).volumeMm3(), 1e-6);
  }

  /** Returns the sum of signed tetrahedra, and checks that each normal fits its corners. */
  private static double stlVolume(ByteBuffer stl, Vec3 middle) {
    double sum = 0;
    for (int t = 84; t < stl.capacity(); t += 50) {
      Vec3 normal = vec(stl, t);
      Vec3 a = vec(stl, t + 12).sub(middle, new Vec3());
      Vec3 b = vec(stl, t + 24).sub(middle, new Vec3());
      Vec3 c = vec(stl, t + 36).sub(middle, new Vec3());
      double volume =
          a.x * (b.y * c.z - b.z * c.y)
              + a.y * (b.z * c.x - b.x * c.z)
              + a.z * (b.x * c.y - b.y * c.x);
      assertTrue(volume * normal.dot(a) >= -1e-6);
      sum += volume / 6;
    }
    return sum;
  }

  private static Vec3 vec(ByteBuffer stl, int at) {
    return new Vec3(stl.getFloat(at), stl.getFloat(at + 4), stl.getFloat(at + 8));
  }
}
