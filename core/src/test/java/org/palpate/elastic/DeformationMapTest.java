package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class DeformationMapTest {
  private static final double EDGE = 4;
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice =
      ElasticTouch.softCube(new BitCube(20, 20, 20), 2, new GridMetric(1, 1.5, 2), EDGE);
  private final RoomProof proof = new RoomProof(lattice);
  private final DeformationField field = new DeformationField(DeformationField.Layout.of(lattice));
  private final DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);

  private void newField(double displaced) {
    do {
      for (int node = 0; node < lattice.layout().nodeCount(); node++) {
        for (int n = 0; n < DeformationField.STRIDE; n++) {
          double size = lattice.cells().isFixed(node) ? 0 : n < 3 ? displaced : 0.01;
          field.whole.values[DeformationField.STRIDE * node + n] =
              (float) (size * (2 * random.nextDouble() - 1));
        }
      }
      field.room.begin(1, 0, 0);
    } while (!proof.prove(field, 2, -1));
    map.use(field);
  }

  private Vec3 randomPoint() {
    return new Vec3(
        -14 + 48 * random.nextDouble(),
        -14 + 48 * random.nextDouble(),
        -14 + 48 * random.nextDouble());
  }

  @Test
  void theInverseUndoesTheMapFromAnyStart() {
    for (int n = 0; n < 20; n++) {
      newField(0.12);
      map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      for (int i = 0; i < 200; i++) {
        Vec3 material = randomPoint();
        ElasticTouch.assertInverseUndoes(map, material, i % 3 == 0 ? randomPoint() : material);
      }
    }
  }

  /** The plain reference looks at every tetrahedron for the one that holds the position. */
  @Test
  void theWalkFindsTheTetrahedronThatAFullSearchFinds() {
    newField(0.12);
    for (int i = 0; i < 40; i++) {
      Vec3 present = new Vec3(2 + 14 * random.nextDouble(), 3 + 14 * random.nextDouble(), 5);
      Vec3 found = map.inverse(present, randomPoint(), new Vec3());
      Vec3 expected = new NaiveInverse(lattice.layout(), map).find(present);
      assertEquals(0, found.sub(expected, new Vec3()).length(), 1e-8);
    }
  }

  /** At the earlier place the field before is in use, for any force, and between both a mixture. */
  @Test
  void aSlideGoesFromTheFieldBeforeToTheNewOne() {
    DeformationField before = new DeformationField(DeformationField.Layout.of(lattice));
    DeformationMap mapBefore = new DeformationMap(DeformationField.Layout.of(lattice), before);
    newField(0.05);
    field.baseNewton[0] = 0.3;
    field.place.set(4, 4, 4);
    before.set(field);
    newField(0.05);
    field.baseNewton[0] = 0.1;
    field.baseNewton[2] = -0.2;
    field.place.set(7, 5, 4);
    field.takeEarlier(before);
    field.slideIntervals = 1;
    assertTrue(proof.prove(field, 2, -1) && field.slideIntervals == 1);
    for (int n = 0; n < 100; n++) {
      Vec3 at = randomPoint();
      Vec3 force = new Vec3(0.1 * random.nextDouble(), 0.1 * random.nextDouble(), -0.1);
      mapBefore.use(before);
      assertFalse(mapBefore.setForce(force.x, force.y, force.z));
      Vec3 early = mapBefore.forward(at, new Vec3());
      map.use(field);
      assertFalse(map.setForce(force.x, force.y, force.z));
      Vec3 late = map.forward(at, new Vec3());
      double part = 1.4 * random.nextDouble() - 0.2;
      map.slideTo(new Vec3(4 + 3 * part, 4 + part, 4));
      double blended = Math.max(0, Math.min(1, part));
      Vec3 expected = early.add(late.sub(early, late).mul(blended, late), early);
      assertEquals(0, map.forward(at, new Vec3()).sub(expected, late).length(), 1e-6);
    }
  }

  @Test
  void theAnswerOfAPointDisplacesItAsTheMapDoes() {
    LocalAnswer answer = new LocalAnswer();
    for (int n = 0; n < 200; n++) {
      newField(0.08);
      field.slideIntervals = n % 2;
      field.earlierPlace.set(4, 4, 4);
      field.place.set(7, 5, 4);
      System.arraycopy(
          field.whole.values, 0, field.whole.earlier, 12, field.whole.values.length - 12);
      map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      Vec3 point = randomPoint();
      map.slideTo(new Vec3(4 + 3 * random.nextDouble(), 4.5, 4));
      map.answer(point, answer);
      Vec3 mm = new Vec3();
      map.displacementMm(answer, mm);
      Vec3 present = new Vec3(point.x + mm.x, point.y + mm.y / 1.5, point.z + mm.z / 2);
      Vec3 expected = map.forward(point, new Vec3());
      assertEquals(0, present.sub(expected, mm).length(), 1e-13, "frame " + n);
    }
  }

  @Test
  void isTheIdentityOutsideTheLatticeAndAtItsRim() {
    newField(0.12);
    for (int axis = 0; axis < 3; axis++) {
      for (int side = 0; side < 2; side++) {
        Vec3 point = randomPoint();
        int origin = lattice.layout().originVoxel(axis);
        int size = lattice.layout().cells(axis) * lattice.layout().voxelsPerCell(axis);
        point.set(axis, side == 0 ? origin : origin + size);
        assertTrue(map.forward(point, new Vec3()).sameBits(point), "rim");
        point.set(axis, side == 0 ? origin - 0.5 : origin + size + 0.5);
        assertTrue(map.forward(point, new Vec3()).sameBits(point), "outside");
        assertTrue(map.inverse(point, randomPoint(), new Vec3()).sameBits(point), "back");
      }
    }
  }

  @Test
  void isContinuousAcrossFaces() {
    newField(0.12);
    for (int i = 0; i < 2000; i++) {
      Vec3 a = randomPoint();
      Vec3 b =
          new Vec3(a.x + 1e-7 * random.nextGaussian(), a.y + 1e-7 * random.nextGaussian(), a.z);
      Vec3 difference = map.forward(a, new Vec3()).sub(map.forward(b, new Vec3()), new Vec3());
      assertTrue(difference.length() < 1e-5, "a jump of " + difference.length());
    }
  }
}
