package org.palpate.scene.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class MarkMeshTest {
  private static final double ROUNDING = 1e-5;
  private static final Vec3 MIDDLE = new Vec3(1, 2, 3);

  private final MarkMesh mesh = new MarkMesh();

  private record Vertex(Vec3 at, Vec3 normal, List<Float> colour) {}

  private List<Vertex> vertices() {
    FloatBuffer floats = mesh.buffer();
    List<Vertex> vertices = new ArrayList<>();
    while (floats.hasRemaining()) {
      vertices.add(
          new Vertex(
              vector(floats),
              vector(floats),
              List.of(floats.get(), floats.get(), floats.get(), floats.get())));
    }
    assertEquals(mesh.vertexCount(), vertices.size());
    return vertices;
  }

  private static Vec3 vector(FloatBuffer floats) {
    return new Vec3(floats.get(), floats.get(), floats.get());
  }

  @Test
  void theVerticesOfABallLieOnItAndTheirNormalsPointOutwards() {
    mesh.ball(MIDDLE, 2);
    assertOnBall(2);
    assertEquals(4.0 / 3 * Math.PI * 8, volume(), 2, "of the ball");
  }

  @Test
  void theVerticesOfADotAreTheCornersOfAnOctahedron() {
    mesh.dot(MIDDLE, 0.5);
    assertEquals(24, mesh.vertexCount());
    assertOnBall(0.5);
    assertEquals(4.0 / 3 / 8, absoluteVolume(), ROUNDING, "of the octahedron");
  }

  private void assertOnBall(double radius) {
    for (Vertex vertex : vertices()) {
      Vec3 out = vertex.at.sub(MIDDLE, new Vec3());
      assertEquals(radius, out.length(), ROUNDING);
      assertEquals(radius, out.dot(vertex.normal), ROUNDING);
    }
  }

  /** Returns the volume within the triangles, by tetrahedra to the middle. */
  private double volume() {
    List<Vertex> all = vertices();
    double six = 0;
    for (int n = 0; n < all.size(); n += 3) {
      six += sixVolumes(all, n);
    }
    return Math.abs(six) / 6;
  }

  /** Does the same for triangles that wind in both directions. */
  private double absoluteVolume() {
    List<Vertex> all = vertices();
    double six = 0;
    for (int n = 0; n < all.size(); n += 3) {
      six += Math.abs(sixVolumes(all, n));
    }
    return six / 6;
  }

  private static double sixVolumes(List<Vertex> all, int n) {
    Vec3 a = all.get(n).at.sub(MIDDLE, new Vec3());
    Vec3 b = all.get(n + 1).at.sub(MIDDLE, new Vec3());
    Vec3 c = all.get(n + 2).at.sub(MIDDLE, new Vec3());
    return a.dot(b.cross(c, new Vec3()));
  }

  @Test
  void aTubeHasItsRadiusAlongEachOfItsParts() {
    mesh.tube(List.of(new Vec3(0, 0, 0), new Vec3(4, 0, 0)), 0.5);
    int perPart = mesh.vertexCount();
    assertRange(0, 4, vertex -> vertex.at.x);
    assertRange(0, 0.5, vertex -> Math.hypot(vertex.at.y, vertex.at.z));
    for (Vertex vertex : vertices()) {
      boolean isCap = vertex.normal.x < 0;
      double outwards = vertex.at.y * vertex.normal.y + vertex.at.z * vertex.normal.z;
      assertEquals(isCap ? 0 : 0.5, outwards, ROUNDING);
      assertEquals(isCap ? -1 : 0, vertex.normal.x, ROUNDING);
    }
    mesh.clear();
    mesh.tube(List.of(new Vec3(0, 0, 0), new Vec3(0, 4, 0), new Vec3(0, 4, 0)), 0.5);
    assertEquals(perPart, mesh.vertexCount(), "a part without length has no triangles");
    mesh.tube(List.of(new Vec3(0, 0, 0), new Vec3(0, 4, 0), new Vec3(0, 4, 7)), 0.5);
    assertEquals(3 * perPart, mesh.vertexCount());
  }

  @Test
  void anArrowEndsInItsTip() {
    mesh.arrow(new Vec3(0, 0, 0), new Vec3(0, 0, 20), 0.5);
    assertRange(0, 20, vertex -> vertex.at.z);
    assertRange(0, 2.6 * 0.5, MarkMeshTest::fromAxisZ);
    assertEquals(20 - 6 * 0.5, widest(), ROUNDING, "where the head begins");
    double leans = vertices().stream().mapToDouble(vertex -> vertex.normal.z).max().orElseThrow();
    assertEquals(2.6 / 6, leans, ROUNDING, "the normals of the head, whose slope is that");
  }

  @Test
  void theHeadOfAShortArrowTakesHalfOfIt() {
    mesh.arrow(new Vec3(0, 0, 0), new Vec3(0, 0, 4), 0.5);
    assertRange(0, 4, vertex -> vertex.at.z);
    assertEquals(2, widest(), ROUNDING, "where the head begins");
  }

  @Test
  void anArrowOrSpringWithoutLengthHasNoTriangles() {
    mesh.arrow(MIDDLE, MIDDLE, 0.5);
    mesh.spring(MIDDLE, MIDDLE, 3, 1, 0.1);
    assertEquals(0, mesh.vertexCount());
  }

  /** Returns how far along z the mesh is widest. */
  private double widest() {
    return vertices().stream()
        .max((a, b) -> Double.compare(fromAxisZ(a), fromAxisZ(b)))
        .orElseThrow()
        .at
        .z;
  }

  private static double fromAxisZ(Vertex vertex) {
    return Math.hypot(vertex.at.x, vertex.at.y);
  }

  @Test
  void aSpringGoesFromEndToEndInTurnsOfItsRadius() {
    mesh.spring(new Vec3(0, 0, 0), new Vec3(0, 0, 10), 5, 2, 0.1);
    List<Vertex> all = vertices();
    double widest = all.stream().mapToDouble(MarkMeshTest::fromAxisZ).max().orElseThrow();
    assertEquals(2, widest, 0.1 + ROUNDING);
    assertEquals(0, all.get(0).at.length(), 0.1 + ROUNDING);
    double top = all.stream().mapToDouble(vertex -> vertex.at.z).max().orElseThrow();
    assertEquals(10, top, 0.1 + ROUNDING);
    for (int quadrant = 0; quadrant < 4; quadrant++) {
      double turn = quadrant * Math.PI / 2;
      double reach =
          all.stream()
              .mapToDouble(vertex -> vertex.at.x * Math.cos(turn) + vertex.at.y * Math.sin(turn))
              .max()
              .orElseThrow();
      assertEquals(2, reach, 0.1 + ROUNDING, "it winds all around");
    }
  }

  @Test
  void shapesHaveTheColourThatWasSetBefore() {
    mesh.colour(0xff8000, 0.5).dot(MIDDLE, 1);
    mesh.colour(0x0000ff, 1).dot(MIDDLE, 1);
    List<Vertex> all = vertices();
    assertEquals(List.of(1f, 128 / 255f, 0f, 0.5f), all.get(23).colour);
    assertEquals(List.of(0f, 0f, 1f, 1f), all.get(24).colour);
  }

  @Test
  void growsAndKeepsWhatItHolds() {
    for (int n = 0; n < 1000; n++) {
      mesh.dot(new Vec3(n, 0, 0), 0);
    }
    List<Vertex> all = vertices();
    assertEquals(24_000, all.size());
    for (int n = 0; n < all.size(); n++) {
      int dot = n / 24;
      assertEquals(dot, all.get(n).at.x);
    }
    mesh.clear();
    assertTrue(vertices().isEmpty());
  }

  private void assertRange(double low, double high, ToDoubleFunction<Vertex> of) {
    assertEquals(low, vertices().stream().mapToDouble(of).min().orElseThrow(), ROUNDING);
    assertEquals(high, vertices().stream().mapToDouble(of).max().orElseThrow(), ROUNDING);
  }
}
