package org.palpate.scene.surface;

import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Writes surfaces to one OBJ file in world mm, a group for each, with colours in an MTL file beside
 * it. Triangles are counter-clockwise seen from outside, even if the transform mirrors.
 *
 * <p>Source: the OBJ and MTL formats of Wavefront's Advanced Visualizer.
 */
public final class ObjFile {
  /** Nine digits read back as the same number of single precision. */
  private static final MathContext DIGITS = new MathContext(9);

  private static final int NORMAL_UNITS = 10_000;

  private ObjFile() {}

  /**
   * A surface with a name and a colour.
   *
   * @param name the name of the group; blanks become underscores
   * @param rgb 0xRRGGBB
   * @param surface the surface in grid mm
   */
  public record Group(String name, int rgb, WeldedSurface surface) {
    String word() {
      return name.strip().replaceAll("[\\s\\p{Cntrl}]+", "_");
    }
  }

  /**
   * Writes the groups.
   *
   * @param gridMmToWorld pose of the surfaces
   * @param comment a line that says what the file holds
   * @param materials name of the MTL file
   */
  public static void write(
      List<Group> groups,
      RigidTransform gridMmToWorld,
      String comment,
      String materials,
      OutputStream out)
      throws IOException {
    Text text = new Text(out);
    text.line("# " + comment);
    text.line("mtllib " + materials);
    int first = 1;
    for (int n = 0; n < groups.size(); n++) {
      Group group = groups.get(n);
      text.line("g " + group.word());
      text.line("usemtl " + materialName(n));
      writeVertices(group.surface(), gridMmToWorld, text);
      writeTriangles(group.surface(), gridMmToWorld.isMirrored(), first, text);
      first += group.surface().vertexCount();
    }
    text.flush();
  }

  /** Returns the text of the MTL file: a colour for each group. */
  public static String materials(List<Group> groups) {
    List<String> lines = new ArrayList<>();
    for (int n = 0; n < groups.size(); n++) {
      int rgb = groups.get(n).rgb();
      lines.add("# " + groups.get(n).word());
      lines.add("newmtl " + materialName(n));
      lines.add("Kd " + part(rgb >> 16) + " " + part(rgb >> 8) + " " + part(rgb));
    }
    return String.join("\n", lines) + "\n";
  }

  private static String materialName(int n) {
    return "segment" + (n + 1);
  }

  private static String part(int value) {
    return new BigDecimal((value & 255) / 255.0).round(new MathContext(4)).toPlainString();
  }

  private static void writeVertices(WeldedSurface surface, RigidTransform toWorld, Text text)
      throws IOException {
    float[] grid = surface.positionsMm();
    short[] packed = surface.normals();
    Vec3 point = new Vec3();
    for (int v = 0; v < surface.vertexCount(); v++) {
      point.set(grid[3 * v], grid[3 * v + 1], grid[3 * v + 2]);
      toWorld.transform(point, point);
      text.line("v " + number(point.x) + " " + number(point.y) + " " + number(point.z));
    }
    for (int v = 0; v < surface.vertexCount(); v++) {
      point.set(packed[4 * v], packed[4 * v + 1], packed[4 * v + 2]);
      toWorld.rotate(point.mul(1.0 / SurfaceBrick.FULL_SCALE, point), point);
      text.line("vn " + rounded(point.x) + " " + rounded(point.y) + " " + rounded(point.z));
    }
  }

  private static void writeTriangles(WeldedSurface surface, boolean mirrored, int first, Text text)
      throws IOException {
    int[] corners = surface.triangles();
    int second = mirrored ? 2 : 1;
    for (int t = 0; t < corners.length; t += 3) {
      text.line(
          "f "
              + corner(corners[t] + first)
              + corner(corners[t + second] + first)
              + corner(corners[t + 3 - second] + first));
    }
  }

  private static String corner(int vertex) {
    return vertex + "//" + vertex + " ";
  }

  private static String number(double value) {
    return new BigDecimal((float) value).round(DIGITS).stripTrailingZeros().toPlainString();
  }

  /** Returns a part of a normal with four decimals. */
  private static String rounded(double value) {
    return BigDecimal.valueOf(Math.round(value * NORMAL_UNITS), 4).toPlainString();
  }

  /** Lines of text, in UTF-8. */
  private static final class Text {
    private static final int BUFFER = 1 << 16;

    private final OutputStream out;
    private final StringBuilder waiting = new StringBuilder();

    Text(OutputStream out) {
      this.out = out;
    }

    void line(String line) throws IOException {
      waiting.append(line.stripTrailing()).append('\n');
      if (waiting.length() > BUFFER) {
        flush();
      }
    }

    void flush() throws IOException {
      out.write(waiting.toString().getBytes(StandardCharsets.UTF_8));
      waiting.setLength(0);
    }
  }
}
