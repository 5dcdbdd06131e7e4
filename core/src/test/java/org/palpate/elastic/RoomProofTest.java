package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class RoomProofTest {
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice =
      ElasticTouch.softCube(new BitCube(16, 16, 16), 2, new GridMetric(1, 1, 1), 4);
  private final RoomProof proof = new RoomProof(lattice);
  private final DeformationField field = new DeformationField(DeformationField.Layout.of(lattice));

  private void randomField(double displaced, double answers) {
    for (int node = 0; node < lattice.layout().nodeCount(); node++) {
      for (int n = 0; n < DeformationField.STRIDE; n++) {
        double size = lattice.cells().isFixed(node) ? 0 : n < 3 ? displaced : answers;
        field.whole.values[DeformationField.STRIDE * node + n] =
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
    DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);
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

  /** Makes the field before by a change of every value, for a slide of two voxels. */
  private void randomSlide(double displaced, double answers) {
    field.earlierPlace.set(5, 8, 8);
    field.place.set(7, 8, 8);
    field.slideIntervals = 1 + random.nextInt(4);
    for (int n = 0; n < field.whole.values.length; n++) {
      boolean fixed = lattice.cells().isFixed(n / DeformationField.STRIDE);
      double size = fixed ? 0 : n % DeformationField.STRIDE < 3 ? displaced : answers;
      field.whole.earlier[n] =
          field.whole.values[n] + (float) (size * (2 * random.nextDouble() - 1));
    }
  }

  @Test
  void noForceInTheRoomFoldsATetrahedronAnywhereOnASlide() {
    int blended = 0;
    int alone = 0;
    DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);
    while (blended < 30 || alone < 3) {
      double displaced = 0.02 + 0.08 * random.nextDouble();
      double answers = Math.pow(10, -2 + 2 * random.nextDouble());
      randomField(displaced, answers);
      randomSlide(3 * displaced * random.nextDouble(), answers * random.nextDouble());
      if (!proof.prove(field, 1 + 3 * random.nextDouble(), -2 * random.nextDouble())) {
        continue;
      }
      blended += field.slideIntervals > 0 ? 1 : 0;
      alone += field.slideIntervals > 0 ? 0 : 1;
      map.use(field);
      for (int n = 0; n < 3; n++) {
        map.slideTo(new Vec3(5 + 2 * random.nextDouble(), 8, 8));
        double size = Math.pow(10, -2 + 3 * random.nextDouble());
        map.setForce(
            size * random.nextGaussian(),
            size * random.nextGaussian(),
            size * random.nextGaussian());
        assertEquals(0, TetrahedraJudge.folded(lattice, map), "field " + blended + " " + alone);
      }
    }
  }

  /**
   * The room must not shrink because cells are skipped: all cells together are the reference. Nor
   * may it be larger than the better of both bounds allows, but for the cones that begin at larger
   * forces.
   */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void theRoomIsAsLargeAsAllCellsAllow(boolean slides) {
    double reach = 2;
    int smaller = 0;
    int clipped = 0;
    for (int n = 0; n < 120; n++) {
      randomField(0.02 + 0.05 * random.nextDouble(), Math.pow(10, -2 + 1.5 * random.nextDouble()));
      field.slideIntervals = 0;
      if (slides) {
        randomSlide(0.2 * random.nextDouble(), random.nextDouble());
      }
      if (!proof.prove(field, reach, 0) || (slides && field.slideIntervals == 0)) {
        continue;
      }
      double[] axis = field.room.axis();
      double along = reach;
      double most = reach;
      for (int cell = 0; cell < lattice.cells().count(); cell++) {
        int first = lattice.cells().firstNode(cell);
        along = Math.min(along, naiveAlong(first, axis, false));
        most = Math.min(most, naiveAlong(first, axis, true));
      }
      assertFalse(clips(0.999 * along), "field " + n + ", cone of " + along + " N");
      assertFalse(clips(-0.999 * along), "field " + n + ", cone of " + along + " N");
      smaller += most < reach ? 1 : 0;
      clipped += most < reach && clips(-1.001 * most) ? 1 : 0;
    }
    assertTrue(smaller > 20 && clipped > 0.8 * smaller, clipped + " of " + smaller);
  }

  /** Whether a change of the force along the axis is clipped. */
  private boolean clips(double newton) {
    double[] change = field.room.axis().clone();
    for (int row = 0; row < 3; row++) {
      change[row] *= newton;
    }
    return field.room.clip(change);
  }

  /**
   * Returns how far the force along an axis may change before a bound of a cell is used up.
   *
   * @param better whether each tetrahedron may use the bound by its distance from rest too
   */
  private double naiveAlong(int firstNode, double[] axis, boolean better) {
    double least = Double.POSITIVE_INFINITY;
    for (int[] order : KuhnTetrahedra.ORDERS) {
      double room = leastNaiveRoom(firstNode, order);
      if (better) {
        double apart = deviation(firstNode, order, 1);
        apart = field.slideIntervals == 0 ? apart : Math.max(apart, deviation(firstNode, order, 0));
        room = Math.max(room, 0.9 * (1 - apart));
      }
      least = Math.min(least, room / answerLength(firstNode, order, axis));
    }
    return least;
  }

  /** Returns the least of the bound by the determinant where the proof looks at the slide. */
  private double leastNaiveRoom(int firstNode, int[] order) {
    int intervals = Math.max(1, field.slideIntervals);
    double slide = field.slideIntervals == 0 ? 0 : slideLength(firstNode, order);
    double least = Double.POSITIVE_INFINITY;
    for (int n = field.slideIntervals == 0 ? 1 : 0; n <= intervals; n++) {
      double room = naiveRoom(firstNode, order, (double) n / intervals);
      least = Math.min(least, room - slide / (2 * intervals));
    }
    return least;
  }

  /** Returns the distance of the edges of a tetrahedron from those at rest. */
  private double deviation(int firstNode, int[] order, int part) {
    float[] values = part == 1 ? field.whole.values : field.whole.earlier;
    double squared = 0;
    for (int step = 0; step < 3; step++) {
      for (int row = 0; row < 3; row++) {
        squared += Math.pow(edge(values, firstNode, order, step, row), 2);
      }
    }
    return Math.sqrt(squared);
  }

  /** Returns 0.9 of the bound of the least singular value of a tetrahedron. */
  private double naiveRoom(int firstNode, int[] order, double part) {
    double[] corners = new double[KuhnTetrahedra.ENTRIES];
    for (int corner = 0; corner < 8; corner++) {
      for (int row = 0; row < 3; row++) {
        corners[3 * corner + row] =
            (corner >> row & 1)
                + part * entry(field.whole.values, firstNode, corner, row)
                + (1 - part) * entry(field.whole.earlier, firstNode, corner, row);
      }
    }
    double squared = 0;
    int last = 0;
    for (int step = 0; step < 3; step++) {
      int next = last | 1 << order[step];
      for (int row = 0; row < 3; row++) {
        squared += Math.pow(corners[3 * next + row] - corners[3 * last + row], 2);
      }
      last = next;
    }
    return 0.9 * 2 * KuhnTetrahedra.determinant(corners, order) / squared;
  }

  private double slideLength(int firstNode, int[] order) {
    double squared = 0;
    for (int step = 0; step < 3; step++) {
      for (int row = 0; row < 3; row++) {
        squared +=
            Math.pow(
                edge(field.whole.values, firstNode, order, step, row)
                    - edge(field.whole.earlier, firstNode, order, step, row),
                2);
      }
    }
    return Math.sqrt(squared);
  }

  /** Returns a bound for both fields of the slide: that of the longer answer of each edge. */
  private double answerLength(int firstNode, int[] order, double[] axis) {
    double squared = 0;
    for (int step = 0; step < 3; step++) {
      double newer = squaredAnswer(field.whole.values, firstNode, order, step, axis);
      double before = squaredAnswer(field.whole.earlier, firstNode, order, step, axis);
      squared += field.slideIntervals == 0 ? newer : Math.max(newer, before);
    }
    return Math.sqrt(squared);
  }

  private double squaredAnswer(
      float[] values, int firstNode, int[] order, int step, double[] axis) {
    double squared = 0;
    for (int row = 0; row < 3; row++) {
      double sum = 0;
      for (int n = 0; n < 3; n++) {
        sum += axis[n] * edge(values, firstNode, order, step, 3 + 3 * n + row);
      }
      squared += sum * sum;
    }
    return squared;
  }

  /** Returns the difference of an entry along an edge of a tetrahedron. */
  private double edge(float[] values, int firstNode, int[] order, int step, int entry) {
    int from = 0;
    for (int n = 0; n < step; n++) {
      from |= 1 << order[n];
    }
    return entry(values, firstNode, from | 1 << order[step], entry)
        - entry(values, firstNode, from, entry);
  }

  private double entry(float[] values, int firstNode, int corner, int entry) {
    int node = firstNode + lattice.layout().cornerOffset(corner);
    return values[DeformationField.STRIDE * node + entry];
  }

  /** Answers to forces across the axis are rounding alone, which large answers make visible. */
  @Test
  void noForceFoldsATetrahedronWhoseAnswersHaveOneDirection() {
    DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);
    for (int n = 0; n < 120; n++) {
      randomField(0.05, 0);
      double size = Math.pow(10, 9 * random.nextDouble());
      double[] axis = field.room.axis();
      for (int at = 0; at < field.whole.values.length; at += DeformationField.STRIDE) {
        boolean fixed = lattice.cells().isFixed(at / DeformationField.STRIDE);
        for (int row = 0; row < 3 && !fixed; row++) {
          double answer = size * (2 * random.nextDouble() - 1);
          for (int force = 0; force < 3; force++) {
            field.whole.values[at + 3 + 3 * force + row] = (float) (axis[force] * answer);
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
    DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);
    int moved = 0;
    for (int n = 0; n < 20; n++) {
      randomField(0.05, 0.5);
      field.room.begin(0, 0, 1);
      for (int at = 0; at < field.whole.values.length; at += DeformationField.STRIDE) {
        Arrays.fill(field.whole.values, at + 9, at + 12, 0); // The answers to a force along z.
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
    DeformationMap map = new DeformationMap(DeformationField.Layout.of(lattice), field);
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
        field.whole.values[DeformationField.STRIDE * free + n] = bad;
        assertFalse(proof.prove(field, 1, 0), "entry " + n);
      }
    }
  }
}
