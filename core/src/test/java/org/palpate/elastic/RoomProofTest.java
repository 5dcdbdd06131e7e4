package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.GridMetric;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class RoomProofTest {
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice = lattice();
  private final RoomProof proof = new RoomProof(lattice.cells());
  private final DeformationField field = new DeformationField(lattice.layout());

  private static ControlLattice lattice() {
    BitCube bits = new BitCube(16, 16, 16);
    ElasticTouch.fill(bits, 2, 14, 2, 14, 2, 14);
    ElasticSegment soft = new ElasticSegment(bits, new ElasticMaterial(1e4, 0.3));
    return new ControlLattice(new GridMetric(1, 1, 1), List.of(soft), List.of(), 4);
  }

  private void randomField(double displaced, double answers) {
    for (int node = 0; node < lattice.layout().nodeCount(); node++) {
      for (int n = 0; n < DeformationField.STRIDE; n++) {
        double size = lattice.cells().isFixed(node) ? 0 : n < 3 ? displaced : answers;
        field.values[DeformationField.STRIDE * node + n] =
            (float) (size * (2 * random.nextDouble() - 1));
      }
    }
    double x = random.nextGaussian();
    double y = random.nextGaussian();
    double z = random.nextGaussian();
    double length = Math.sqrt(x * x + y * y + z * z);
    field.room.begin(x / length, y / length, z / length);
  }

  @Test
  void noForceInTheRoomFoldsATetrahedron() {
    int proved = 0;
    int moved = 0;
    DeformationMap map = new DeformationMap(lattice.layout(), field);
    while (proved < 30) {
      randomField(0.02 + 0.1 * random.nextDouble(), Math.pow(10, -2 + 2 * random.nextDouble()));
      if (!proof.prove(field, 1 + 3 * random.nextDouble(), -2 * random.nextDouble())) {
        continue;
      }
      proved++;
      map.use(field);
      for (int n = 0; n < 3; n++) {
        double size = Math.pow(10, -2 + 3 * random.nextDouble());
        boolean clipped =
            map.setForce(
                size * random.nextGaussian(),
                size * random.nextGaussian(),
                size * random.nextGaussian());
        moved += clipped ? 1 : 0;
        assertEquals(0, TetrahedraJudge.folded(lattice, map), "field " + proved);
      }
    }
    assertTrue(moved > 15 && moved < 88, "clipped " + moved);
  }

  /** The room must not shrink because cells are skipped: all cells together are the reference. */
  @Test
  void theRoomIsAsLargeAsAllCellsAllow() {
    double reach = 2;
    double[] change = new double[3];
    for (int n = 0; n < 60; n++) {
      randomField(0.02 + 0.05 * random.nextDouble(), Math.pow(10, -2 + 1.5 * random.nextDouble()));
      if (!proof.prove(field, reach, 0)) {
        continue;
      }
      double[] axis = field.room.axis();
      double along = reach;
      for (int cell = 0; cell < lattice.cells().count(); cell++) {
        along = Math.min(along, naiveAlong(lattice.cells().firstNode(cell), axis));
      }
      for (double sign : new double[] {-1, 1}) {
        for (int row = 0; row < 3; row++) {
          change[row] = sign * 0.999 * along * axis[row];
        }
        assertFalse(field.room.clip(change), "field " + n + ", cone of " + along + " N");
      }
    }
  }

  /** Returns how far the force along an axis may change before a bound of a cell is used up. */
  private double naiveAlong(int firstNode, double[] axis) {
    double least = Double.POSITIVE_INFINITY;
    for (int[] order : KuhnTetrahedra.ORDERS) {
      double[] corners = new double[KuhnTetrahedra.ENTRIES];
      double squared = 0;
      double answers = 0;
      int last = 0;
      for (int step = 0; step < 3; step++) {
        int next = last | 1 << order[step];
        for (int row = 0; row < 3; row++) {
          double length = position(firstNode, next, row) - position(firstNode, last, row);
          double answer = answer(firstNode, next, row, axis) - answer(firstNode, last, row, axis);
          squared += length * length;
          answers += answer * answer;
        }
        last = next;
      }
      for (int corner = 0; corner < 8; corner++) {
        for (int row = 0; row < 3; row++) {
          corners[3 * corner + row] = position(firstNode, corner, row);
        }
      }
      double determinant = KuhnTetrahedra.determinant(corners, order);
      least = Math.min(least, 0.9 * 2 * determinant / squared / Math.sqrt(answers));
    }
    return least;
  }

  private double position(int firstNode, int corner, int row) {
    int node = firstNode + lattice.layout().cornerOffset(corner);
    return (corner >> row & 1) + (double) field.values[DeformationField.STRIDE * node + row];
  }

  private double answer(int firstNode, int corner, int row, double[] axis) {
    int at = DeformationField.STRIDE * (firstNode + lattice.layout().cornerOffset(corner)) + row;
    double sum = 0;
    for (int n = 0; n < 3; n++) {
      sum += axis[n] * field.values[at + 3 + 3 * n];
    }
    return sum;
  }

  /** Answers to forces across the axis are rounding alone, which large answers make visible. */
  @Test
  void noForceFoldsATetrahedronWhoseAnswersHaveOneDirection() {
    DeformationMap map = new DeformationMap(lattice.layout(), field);
    for (int n = 0; n < 60; n++) {
      randomField(0.05, 0);
      double size = Math.pow(10, 9 * random.nextDouble());
      double[] axis = field.room.axis();
      for (int at = 0; at < field.values.length; at += DeformationField.STRIDE) {
        boolean fixed = lattice.cells().isFixed(at / DeformationField.STRIDE);
        for (int row = 0; row < 3 && !fixed; row++) {
          double answer = size * (2 * random.nextDouble() - 1);
          for (int force = 0; force < 3; force++) {
            field.values[at + 3 + 3 * force + row] = (float) (axis[force] * answer);
          }
        }
      }
      assertTrue(proof.prove(field, 4, -2), "field " + n);
      map.use(field);
      for (int i = 0; i < 5; i++) {
        map.setForce(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        assertEquals(0, TetrahedraJudge.folded(lattice, map), "answers of " + size);
      }
    }
  }

  /**
   * The cones of such cells are infinite along the axis, so that only their width bounds a force.
   */
  @Test
  void noForceFoldsATetrahedronThatDoesNotAnswerAlongTheAxis() {
    DeformationMap map = new DeformationMap(lattice.layout(), field);
    int moved = 0;
    for (int n = 0; n < 20; n++) {
      randomField(0.05, 0.5);
      field.room.begin(0, 0, 1);
      for (int at = 0; at < field.values.length; at += DeformationField.STRIDE) {
        Arrays.fill(field.values, at + 9, at + 12, 0); // The answers to a force along z.
      }
      assertTrue(proof.prove(field, 4, -2), "field " + n);
      map.use(field);
      for (int i = 0; i < 5; i++) {
        double x = 3 * random.nextGaussian();
        double y = 3 * random.nextGaussian();
        moved += map.setForce(x, y, random.nextGaussian()) ? 1 : 0;
        assertEquals(0, TetrahedraJudge.folded(lattice, map), "field " + n);
      }
    }
    assertTrue(moved > 50, "clipped " + moved);
  }

  @Test
  void aFieldThatFoldsIsNotProved() {
    DeformationMap map = new DeformationMap(lattice.layout(), field);
    int folded = 0;
    int proved = 0;
    for (int n = 0; n < 120; n++) {
      randomField(0.6 * random.nextDouble(), 0.1);
      map.use(field);
      boolean isProved = proof.prove(field, 2, 0);
      proved += isProved ? 1 : 0;
      if (TetrahedraJudge.folded(lattice, map) > 0) {
        folded++;
        assertFalse(isProved);
      }
    }
    assertTrue(folded > 10 && proved > 10, folded + " folded, " + proved + " proved");
  }

  @Test
  void aFieldThatIsNotFiniteIsNotProved() {
    for (float bad : new float[] {Float.NaN, Float.POSITIVE_INFINITY}) {
      int free = lattice.cells().firstNode(lattice.cells().count() / 2);
      for (int n = 0; n < DeformationField.STRIDE; n++) {
        randomField(0.01, 0.01);
        field.values[DeformationField.STRIDE * free + n] = bad;
        assertFalse(proof.prove(field, 1, 0), "entry " + n);
      }
    }
  }
}
