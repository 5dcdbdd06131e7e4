package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Random fields with a window: one continuous map, and its proof. */
class WindowFieldTest {
  private static final double EDGE = 4;
  private static final double SMALL_NEWTON = 1e-3;
  private static final double LARGE_NEWTON = 1e4;
  private final Random random = new Random(Seeds.seed());
  private ControlLattice lattice;
  private WindowNodes nodes;
  private DeformationField field;
  private DeformationField before;
  private DeformationMap map;
  private RoomProof proof;

  /** Makes a lattice with 2 or 4 cells of the window along an edge. */
  private void makeLattice(int factor) {
    BitCube bits = new BitCube(20, 20, 20);
    ElasticTouch.fill(bits, 2, 18, 2, 18, 2, 18);
    ElasticSegment soft = new ElasticSegment(bits, new ElasticMaterial(1e4, 0.3));
    OptionalDouble radius = OptionalDouble.of(2 * EDGE / factor);
    lattice = new ControlLattice(new GridMetric(1, 1, 1), List.of(soft), List.of(), EDGE, radius);
    DeformationField.Layout layout = DeformationField.Layout.of(lattice);
    nodes = layout.window().orElseThrow();
    assertEquals(factor, nodes.factor());
    field = new DeformationField(layout);
    before = new DeformationField(layout);
    map = new DeformationMap(layout, field);
    proof = new RoomProof(lattice);
  }

  private float random(double size) {
    return (float) (size * (2 * random.nextDouble() - 1));
  }

  private void fill(DeformationField dest, double displaced, double answers) {
    for (int node = 0; node < lattice.layout().nodeCount(); node++) {
      for (int n = 0; n < DeformationField.STRIDE; n++) {
        double size = lattice.cells().isFixed(node) ? 0 : n < 3 ? displaced : answers;
        dest.whole.values[DeformationField.STRIDE * node + n] = random(size);
      }
    }
    WindowNodes.round(dest.whole.values);
    dest.window.present = true;
    for (int axis = 0; axis < 3; axis++) {
      int room = lattice.layout().cells(axis) - nodes.wholeCells(axis);
      dest.window.firstCell[axis] = random.nextInt(room + 1);
    }
    int first = nodes.firstNode(dest.window.firstCell);
    float[] inWindow = dest.window.values.values;
    for (int node = 0; node < nodes.layout().nodeCount(); node++) {
      nodes.interpolateNode(dest.whole.values, first, node, inWindow);
      for (int n = 0; n < DeformationField.STRIDE; n++) {
        inWindow[DeformationField.STRIDE * node + n] += random(n < 3 ? displaced : answers);
      }
    }
    dest.window.takeSides(dest.whole.values);
  }

  /** Makes a field that is blended with one whose window may stand elsewhere. */
  private void newSlide(double displaced, double answers) {
    fill(before, displaced, answers);
    before.place.set(5, 8, 8);
    before.baseNewton[0] = 0.1;
    fill(field, displaced, answers);
    field.place.set(7, 8, 8);
    field.takeEarlier(before);
    field.slideIntervals = 2;
    field.room.begin(0, 0, -1);
  }

  private void newProvedSlide(double displaced, double answers) {
    do {
      newSlide(displaced, answers);
    } while (!proof.prove(field, 2, -1) || field.slideIntervals == 0);
    map.use(field);
    map.slideTo(new Vec3(5 + 2 * random.nextDouble(), 8, 8));
  }

  private Vec3 randomPoint() {
    return new Vec3(
        -10 + 40 * random.nextDouble(),
        -10 + 40 * random.nextDouble(),
        -10 + 40 * random.nextDouble());
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 4})
  void theSidesAreThoseOfTheLatticeToTheBit(int factor) {
    makeLattice(factor);
    for (int n = 0; n < 4; n++) {
      newSlide(Math.pow(10, -6 + 2 * n), Math.pow(10, 3 - 4 * n));
      assertEquals(0, TetrahedraJudge.gaps(lattice, field));
    }
    float[] inWindow = field.window.values.values;
    inWindow[4] = Math.nextUp(inWindow[4]); // The first node is a corner of the window.
    assertEquals(1, TetrahedraJudge.gaps(lattice, field));
    field.window.values.earlier[5] = Math.nextDown(field.window.values.earlier[5]);
    assertEquals(2, TetrahedraJudge.gaps(lattice, field));
  }

  @Test
  void valuesThatAreNotRoundedLeaveGaps() {
    makeLattice(2);
    fill(field, 0.1, 0.1);
    for (int node = 0; node < lattice.layout().nodeCount(); node++) {
      boolean fixed = lattice.cells().isFixed(node);
      field.whole.values[DeformationField.STRIDE * node] = random(fixed ? 0 : 0.1);
    }
    field.window.takeSides(field.whole.values);
    assertTrue(TetrahedraJudge.gaps(lattice, field) > 10);
  }

  @Test
  void roundingChangesAValueByLittle() {
    makeLattice(2);
    for (int n = 0; n < 100; n++) {
      float[] values = new float[DeformationField.STRIDE * 5];
      double most = 0;
      for (int at = 0; at < values.length; at++) {
        values[at] = random(Math.pow(10, -n % 9));
        most = at % DeformationField.STRIDE < 3 ? Math.max(most, Math.abs(values[at])) : most;
      }
      float[] rounded = values.clone();
      WindowNodes.round(rounded);
      for (int at = 0; at < values.length; at += DeformationField.STRIDE) {
        assertEquals(values[at], rounded[at], most / (1 << 22));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 4})
  void theInverseUndoesTheMapFromAnyStart(int factor) {
    makeLattice(factor);
    int inWindow = 0;
    for (int n = 0; n < 6; n++) {
      newProvedSlide(0.06, 0.005);
      map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      for (int i = 0; i < 300; i++) {
        Vec3 material = randomPoint();
        ElasticTouch.assertInverseUndoes(map, material, i % 3 == 0 ? randomPoint() : material);
        inWindow += isInWindow(material) ? 1 : 0;
      }
    }
    assertTrue(inWindow > 50 && inWindow < 1750, inWindow + " in the window");
  }

  private boolean isInWindow(Vec3 material) {
    boolean inside = true;
    for (int axis = 0; axis < 3; axis++) {
      double at = (material.get(axis) - lattice.layout().originVoxel(axis)) / EDGE;
      int first = field.window.firstCell[axis];
      inside &= at >= first && at <= first + nodes.wholeCells(axis);
    }
    return inside;
  }

  /** A crossing of the sides is no jump, for any force in the room and anywhere on the slide. */
  @ParameterizedTest
  @ValueSource(ints = {2, 4})
  void isContinuousAcrossTheSides(int factor) {
    makeLattice(factor);
    for (int n = 0; n < 5; n++) {
      newProvedSlide(0.06, 0.005);
      map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      for (int i = 0; i < 300; i++) {
        Vec3 a = randomPoint();
        int axis = random.nextInt(3);
        int cells = random.nextBoolean() ? 0 : nodes.wholeCells(axis);
        double side =
            lattice.layout().originVoxel(axis) + EDGE * (field.window.firstCell[axis] + cells);
        Vec3 b = new Vec3().set(a);
        a.set(axis, side - 1e-9);
        b.set(axis, side + 1e-9);
        Vec3 way = map.forward(a, new Vec3()).sub(map.forward(b, new Vec3()), new Vec3());
        assertTrue(way.length() < 1e-8, "a jump of " + way.length());
      }
    }
  }

  @Test
  void theAnswerOfAPointDisplacesItAsTheMapDoes() {
    makeLattice(2);
    LocalAnswer answer = new LocalAnswer();
    for (int n = 0; n < 20; n++) {
      newProvedSlide(0.06, 0.005);
      map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      for (int i = 0; i < 20; i++) {
        Vec3 point = randomPoint();
        map.answer(point, answer);
        Vec3 present = new Vec3();
        map.displacementMm(answer, present);
        present.add(point, present);
        Vec3 expected = map.forward(point, new Vec3());
        assertEquals(0, present.sub(expected, expected).length(), 1e-12);
      }
    }
  }

  /** Small forces lie in the room and are kept, large ones are clipped to it. */
  @ParameterizedTest
  @ValueSource(ints = {2, 4})
  void noForceInTheRoomFoldsATetrahedronAnywhereOnASlide(int factor) {
    makeLattice(factor);
    for (double newton : new double[] {SMALL_NEWTON, 0.1, 1, 10, LARGE_NEWTON}) {
      newProvedSlide(0.08, Math.pow(10, -2 + random.nextDouble()));
      Vec3 wanted = new Vec3(random(newton), random(newton), -newton * random.nextDouble());
      boolean clipped = map.setForce(wanted.x, wanted.y, wanted.z);
      if (newton == SMALL_NEWTON || newton == LARGE_NEWTON) {
        assertEquals(newton == LARGE_NEWTON, clipped, wanted + " N");
      }
      assertEquals(0, TetrahedraJudge.folded(lattice, map), wanted + " N");
      Vec3 used = new Vec3();
      map.force(used);
      assertEquals(clipped, used.sub(wanted, used).length() > 0, wanted + " N, off by " + used);
    }
  }

  @Test
  void aFoldInTheWindowIsFoundAndOneUnderItDoesNotMatter() {
    makeLattice(2);
    fill(field, 0, 0);
    field.room.begin(0, 0, -1);
    int[] firstCell = field.window.firstCell;
    int under = lattice.layout().node(firstCell[0] + 2, firstCell[1] + 2, firstCell[2] + 2);
    field.whole.values[DeformationField.STRIDE * under] = 1.5f;
    assertTrue(proof.prove(field, 1, 0), "under the window");
    map.use(field);
    assertEquals(0, TetrahedraJudge.folded(lattice, map));
    int inside = nodes.layout().node(4, 4, 4);
    field.window.values.values[DeformationField.STRIDE * inside] = 1.5f;
    field.room.begin(0, 0, -1);
    assertFalse(proof.prove(field, 1, 0), "in the window");
    assertTrue(TetrahedraJudge.folded(lattice, map) > 0);
    field.window.present = false;
    field.room.begin(0, 0, -1);
    assertFalse(proof.prove(field, 1, 0), "without the window");
  }
}
