package org.palpate.io.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.TriangleMesh;

class MeshFilesTest {
  /** The cuboid from 0, 0, 0 to 2, 3, 5: vertices and quadrilaterals that face outward. */
  private static final int[][] QUADS = {
    {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}
  };

  @TempDir Path folder;

  private static double coordinate(int vertex, int axis) {
    return (vertex >> axis & 1) * new double[] {2, 3, 5}[axis];
  }

  private Path file(String name, byte[] bytes) throws IOException {
    return Files.write(folder.resolve(name), bytes);
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  private static byte[] binaryStl(String header) {
    ByteBuffer out = ByteBuffer.allocate(84 + 50 * 12).order(ByteOrder.LITTLE_ENDIAN);
    out.put(Arrays.copyOf(ascii(header), 80)).putInt(12);
    for (int[] quad : QUADS) {
      putTriangle(out, quad[0], quad[1], quad[2]);
      putTriangle(out, quad[0], quad[2], quad[3]);
    }
    return out.array();
  }

  private static void putTriangle(ByteBuffer out, int... vertices) {
    out.putFloat(0).putFloat(0).putFloat(0);
    for (int vertex : vertices) {
      for (int axis = 0; axis < 3; axis++) {
        out.putFloat((float) coordinate(vertex, axis));
      }
    }
    out.putShort((short) 0);
  }

  private static String textStl() {
    StringBuilder text = new StringBuilder("solid box of mine\n");
    for (int[] quad : QUADS) {
      addFacet(text, quad[0], quad[1], quad[2]);
      addFacet(text, quad[0], quad[2], quad[3]);
    }
    return text.append("endsolid box of mine\n").toString();
  }

  private static void addFacet(StringBuilder text, int... vertices) {
    text.append(" facet normal 0 0 0\n  outer loop\n");
    for (int vertex : vertices) {
      text.append("   vertex ");
      for (int axis = 0; axis < 3; axis++) {
        text.append(coordinate(vertex, axis)).append(' ');
      }
      text.append('\n');
    }
    text.append("  endloop\n endfacet\n");
  }

  private static String obj() {
    StringBuilder text = new StringBuilder("# a box\no box\n");
    for (int vertex = 0; vertex < 8; vertex++) {
      text.append("v ").append(coordinate(vertex, 0)).append(' ').append(coordinate(vertex, 1));
      text.append(' ').append(coordinate(vertex, 2)).append(" 1.0\n");
    }
    text.append("vn 0 0 1\nvt 0 0\ns off\n");
    for (int[] q : QUADS) {
      text.append("f " + (q[0] + 1) + "/1/1 " + (q[1] - 8) + "//1 \\\n " + (q[2] + 1) + " ");
      text.append((q[3] + 1) + "/1 # a side\n");
    }
    return text.toString();
  }

  private static String plyHeader(String format) {
    return "ply\nformat "
        + format
        + " 1.0\ncomment a box\nelement material 1\nproperty list uchar int parts\n"
        + "property double shine\nelement vertex 8\nproperty uchar red\nproperty float x\n"
        + "property float y\nproperty double z\nelement face 6\n"
        + "property list uchar uint vertex_indices\nproperty short flag\nend_header\n";
  }

  private static byte[] textPly() {
    StringBuilder text = new StringBuilder(plyHeader("ascii")).append("2 7 8 0.5\n");
    for (int vertex = 0; vertex < 8; vertex++) {
      text.append("255 " + coordinate(vertex, 0) + " " + coordinate(vertex, 1));
      text.append(" " + coordinate(vertex, 2) + "\n");
    }
    for (int[] q : QUADS) {
      text.append("4 " + q[0] + " " + q[1] + " " + q[2] + " " + q[3] + " -1\n");
    }
    return ascii(text.toString());
  }

  private static byte[] binaryPly(ByteOrder order) {
    String name = order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian";
    byte[] header = ascii(plyHeader(name));
    ByteBuffer out = ByteBuffer.allocate(header.length + 17 + 8 * 17 + 6 * 19).order(order);
    out.put(header).put((byte) 2).putInt(7).putInt(8).putDouble(0.5);
    for (int vertex = 0; vertex < 8; vertex++) {
      out.put((byte) 200).putFloat((float) coordinate(vertex, 0));
      out.putFloat((float) coordinate(vertex, 1)).putDouble(coordinate(vertex, 2));
    }
    for (int[] q : QUADS) {
      out.put((byte) 4).putInt(q[0]).putInt(q[1]).putInt(q[2]).putInt(q[3]).putShort((short) -1);
    }
    return out.array();
  }

  @Test
  void axesThatACommentNamesAreTurnedIntoTheWorld() throws Exception {
    byte[] ply =
        ascii(new String(textPly(), StandardCharsets.ISO_8859_1).replace("a box", "SPACE=RAS"));
    for (Path ras :
        new Path[] {
          file("r.stl", binaryStl("made by hand; SPACE=RAS")),
          file("rt.stl", ascii(textStl().replace("of mine", "SPACE=RAS"))),
          file("r.obj", ascii(obj().replace("# a box", "# SPACE=RAS"))),
          file("r.ply", ply)
        }) {
      assertEquals(CoordinateSystem.RAS, MeshFiles.axes(ras), ras.toString());
      TriangleMesh turned = MeshFiles.read(ras, CoordinateSystem.LPS);
      assertTrue(turned.isClosed());
      assertTrue(turned.low().sameBits(new Vec3(-2, -3, 0)), turned.low().toString());
      assertTrue(turned.high().sub(new Vec3(0, 0, 5), new Vec3()).length() == 0);
      assertIsBox(MeshFiles.read(ras, CoordinateSystem.RAS));
      assertIsBox(MeshFiles.read(ras, CoordinateSystem.UNKNOWN));
    }
    Path unnamed = file("u.stl", binaryStl("SPACE=RASTER"));
    assertEquals(CoordinateSystem.UNKNOWN, MeshFiles.axes(unnamed));
    assertIsBox(MeshFiles.read(unnamed, CoordinateSystem.LPS));
  }

  @Test
  void readsTheSameBoxInEveryFormat() throws Exception {
    assertIsBox(file("a.stl", binaryStl("made by hand")));
    assertIsBox(file("solid.stl", binaryStl("solid by its name, but binary")));
    assertIsBox(file("b.STL", ascii(textStl())));
    assertIsBox(file("crlf.stl", ascii(textStl().replace("\n", "\r\n"))));
    assertIsBox(file("c.obj", ascii(obj())));
    assertIsBox(file("d.ply", textPly()));
    assertIsBox(file("e.ply", binaryPly(ByteOrder.LITTLE_ENDIAN)));
    assertIsBox(file("f.ply", binaryPly(ByteOrder.BIG_ENDIAN)));
  }

  private static void assertIsBox(Path file) throws VolumeFormatException {
    assertTrue(MeshFiles.accepts(file));
    assertIsBox(MeshFiles.read(file));
  }

  private static void assertIsBox(TriangleMesh mesh) {
    assertTrue(mesh.isClosed());
    assertEquals(12, mesh.triangleCount());
    assertEquals(62, mesh.areaMm2(), 1e-9);
    assertEquals(2, mesh.high().x);
    assertEquals(3, mesh.high().y);
    assertEquals(5, mesh.high().z);
  }

  @Test
  void aMeshWithAMissingSideIsOpen() throws Exception {
    String text = obj();
    int last = text.lastIndexOf("f ");
    assertFalse(MeshFiles.read(file("open.obj", ascii(text.substring(0, last)))).isClosed());
  }

  @Test
  void aFileThatIsTooShortIsToBeCopiedAgain() throws Exception {
    byte[][] whole = {binaryStl("x"), ascii(textStl()), textPly(), binaryPly(ByteOrder.BIG_ENDIAN)};
    String[] names = {"a.stl", "b.stl", "c.ply", "d.ply"};
    for (int n = 0; n < whole.length; n++) {
      for (int length : new int[] {3, 40, whole[n].length / 2, whole[n].length - 25}) {
        Path file = file(names[n], Arrays.copyOf(whole[n], length));
        String line = refusal(file);
        assertTrue(line.contains("again"), length + ": " + line);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "v 0 0 0|v 1 0 0|v 0 1 0|f 1 2 4|",
        "v 0 0 0|v 1 0 0|v 0 1 0|f 0 1 2|",
        "v 0 0 0|v 1 0 0|v 0 1 0|f -4 1 2|",
        "v 0 0 0|v 1 0 0|v 0 1 0|f 1 2|",
        "v 0 0 0|v 1 0 0|v 0 1 0|f 1 2 x|",
        "v 0 0 0|v 1 0 0|v 0 1|f 1 2 3|",
        "v 0 0 nan|v 1 0 0|v 0 1 0|f 1 2 3|",
        "v 0 0 1e300|v 1 0 0|v 0 1 0|f 1 2 3|",
        "v 0 0 0|v 0 0 0|v 0 1 0|f 1 2 3|",
        "nothing of use|"
      })
  void aDamagedObjFileIsRefusedInOneLine(String text) throws Exception {
    refusal(file("a.obj", ascii(text.replace('|', '\n'))));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "plx|",
        "ply|format ascii 1.0|end_header|",
        "ply|format pdf 1.0|end_header|",
        "ply|format ascii 1.0|element vertex 99999999999|end_header|",
        "ply|format ascii 1.0|element vertex -1|end_header|",
        "ply|format ascii 1.0|property float x|end_header|",
        "ply|format ascii 1.0|element vertex 2000000000|property float x|end_header|0|",
        "ply|format ascii 1.0|element vertex 1|property quad x|end_header|0|",
        "ply|format ascii 1.0|element vertex 1|property float x|end_header|0|",
        "ply|format ascii 1.0|element face 1|property list int int vertex_index|end_header|-3|",
        "ply|format ascii 1.0|element face 1|property list int int vertex_index|end_header|3 0 1"
            + " 2|",
        "ply|format ascii 1.0|element face 1|property list int float vertex_index|end_header|3 0 .5"
            + " 2|"
      })
  void aDamagedPlyFileIsRefusedInOneLine(String text) throws Exception {
    refusal(file("a.ply", ascii(text.replace('|', '\n'))));
  }

  @Test
  void aHeaderThatPromisesTooMuchAllocatesNothing() throws Exception {
    byte[] stl = binaryStl("x");
    ByteBuffer.wrap(stl).order(ByteOrder.LITTLE_ENDIAN).putInt(80, -2);
    assertTrue(refusal(file("a.stl", stl)).contains("promises"));
    String ply =
        """
        ply
        format binary_little_endian 1.0
        element vertex 2000000000
        property float x
        property float y
        property float z
        end_header
        """;
    assertTrue(refusal(file("a.ply", ascii(ply))).contains("promises"));
  }

  @Test
  void missingAndEmptyFilesAreRefused() throws Exception {
    assertTrue(refusal(folder.resolve("none.stl")).contains("no such file"));
    assertTrue(refusal(file("empty.obj", new byte[0])).contains("empty"));
    Files.createDirectory(folder.resolve("folder.ply"));
    assertTrue(refusal(folder.resolve("folder.ply")).contains("not a regular file"));
  }

  @Test
  void anyDamagedFileIsReadOrRefusedInOneLine() throws Exception {
    long seed = Long.getLong("palpate.seed", 20261128);
    Random random = new Random(seed);
    byte[][] whole = {
      binaryStl("x"),
      ascii(textStl()),
      ascii(obj()),
      textPly(),
      binaryPly(ByteOrder.LITTLE_ENDIAN),
      binaryPly(ByteOrder.BIG_ENDIAN)
    };
    String[] names = {"a.stl", "b.stl", "c.obj", "d.ply", "e.ply", "f.ply"};
    int refused = 0;
    for (int n = 0; n < 6000; n++) {
      int which = n % whole.length;
      byte[] bytes = whole[which].clone();
      for (int damage = random.nextInt(4); damage >= 0; damage--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      }
      bytes = random.nextInt(4) == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
      Path file = file(names[which], bytes);
      try {
        MeshFiles.read(file);
      } catch (VolumeFormatException e) {
        refused++;
        assertEquals(1, e.getMessage().lines().count(), e.getMessage());
      } catch (RuntimeException | Error e) {
        throw new AssertionError("seed " + seed + " case " + n, e);
      }
    }
    assertTrue(refused > 1000 && refused < 5900, "refused " + refused);
  }

  private static String refusal(Path file) {
    String line =
        assertThrows(VolumeFormatException.class, () -> MeshFiles.read(file)).getMessage();
    assertEquals(1, line.lines().count(), line);
    assertTrue(line.contains(file.getFileName().toString()), line);
    return line;
  }
}
