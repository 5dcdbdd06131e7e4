package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.edit.BrushEdit;
import org.palpate.elastic.lattice.WindowLattice;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;

/** A contact that is sharper than two cells, in a window with shorter cells. */
class ElasticWindowTest {
  private static final double NEWTON_PER_MM = 0.5;

  private static ElasticTouch above(double edgeMm, double radiusMm) {
    ElasticTouch touch =
        new ElasticTouch(
            ElasticTouch.Scene.block(new GridMetric(1, 1, 1)),
            20e3,
            ForceSettings.of(NEWTON_PER_MM, 0),
            edgeMm,
            OptionalDouble.of(radiusMm),
            false);
    touch.hand.set(38.3, 48.4, 52);
    for (int n = 0; n < 40; n++) {
      touch.run();
    }
    return touch;
  }

  private static DeformationField field(ElasticTouch touch) {
    return touch.body.contact().map().field();
  }

  /** The reference has short cells everywhere. Long ones alone give a fifth less force. */
  @ParameterizedTest
  @CsvSource({"8, 8, 4", "8, 4, 2"})
  void pressesAsAWholeLatticeOfShortCellsDoes(double edge, double radius, double shortEdge) {
    double[] newton = new double[2];
    int[] hexes = new int[2];
    for (int n = 0; n < 2; n++) {
      ElasticTouch touch = above(n == 0 ? edge : shortEdge, radius);
      assertEquals(n == 0, touch.lattice.window().isPresent());
      touch.moveTo(38.3, 48.4, 44, 200);
      touch.moveTo(38.3, 48.4, 44, 150);
      assertEquals(n == 0, field(touch).hasWindow());
      newton[n] = touch.frame.forceNewton().z;
      hexes[n] = touch.body.hexahedra();
    }
    System.out.printf(
        "in a window %.4f N, %d hexes; in a whole lattice %.4f N, %d hexes%n",
        newton[0], hexes[0], newton[1], hexes[1]);
    assertEquals(newton[1], newton[0], 0.03 * newton[1]);
  }

  /** The bounds are what a whole lattice of cells of 4 mm has, over the force upwards. */
  @ParameterizedTest
  @CsvSource({"5, 0.078", "10, 0.296"})
  void aSlideIsHeldBackNoMoreThanOnAWholeLatticeOfShortCells(double depthMm, double most) {
    double held = heldBack(above(8, 8), depthMm);
    assertTrue(held < most, "held back by " + held);
  }

  /** Slides 24 mm at 60 mm/s, and returns the force against the motion over that upwards. */
  private static double heldBack(ElasticTouch touch, double depthMm) {
    touch.moveTo(38.3, 48.4, 48 - depthMm, 300);
    touch.moveTo(38.3, 48.4, 48 - depthMm, 300);
    Vec3 last = new Vec3();
    Vec3 change = new Vec3();
    double back = 0;
    double up = 0;
    int steps = 0;
    for (int n = 0; n < 400; n++) {
      last.set(touch.frame.forceNewton());
      touch.hand.x += 0.06;
      touch.run();
      back -= touch.frame.forceNewton().x;
      up += touch.frame.forceNewton().z;
      touch.frame.forceNewton().sub(last, change);
      steps += change.length() > NEWTON_PER_MM * 0.06 + 1e-3 ? 1 : 0;
    }
    System.out.printf(
        "%d hexes, %.0f mm deep: back %.3f, up %.3f N, %d steps%n",
        touch.body.hexahedra(), depthMm, back / 400, up / 400, steps);
    return back / up;
  }

  @Test
  void theWindowFollowsASlide() {
    ElasticTouch touch = above(8, 8);
    touch.moveTo(38.3, 48.4, 43, 300);
    int moves = 0;
    int first = field(touch).window.firstCell[0];
    for (int n = 0; n < 400; n++) {
      touch.hand.x += 0.06;
      touch.run();
      DeformationField used = field(touch);
      moves += used.window.firstCell[0] == first ? 0 : 1;
      first = used.window.firstCell[0];
      assertTrue(used.hasWindow(), "frame " + n);
      double at = (touch.frame.point().position.x - touch.lattice.layout().originVoxel(0)) / 8;
      assertTrue(at > first + 1.5 && at < first + 4.5, "at " + at + " of the window at " + first);
      if (n % 33 == 32) {
        assertEquals(0, TetrahedraJudge.folded(touch.lattice, touch.body.contact().map()));
        assertEquals(0, TetrahedraJudge.gaps(touch.lattice, used));
      }
    }
    assertTrue(moves >= 2 && moves <= 4, "moves " + moves);
    assertEquals(0, touch.body.counters().windowless());
  }

  /** The matter of the window is that of a new one, after edits inside and where it goes next. */
  @Test
  void editsReachTheWindowWhereverItStands() {
    ElasticTouch touch = above(8, 8);
    touch.moveTo(38.3, 48.4, 46, 100);
    touch.edits.offer(new BrushEdit(0, new Vec3(38, 48, 40), 5, false));
    touch.edits.offer(new BrushEdit(0, new Vec3(58, 48, 44), 4, false));
    touch.moveTo(38.3, 48.4, 46, 70);
    assertMatterIsThatOfItsVoxels(touch);
    touch.moveTo(58.3, 48.4, 46, 200);
    touch.moveTo(58.3, 48.4, 46, 70);
    assertMatterIsThatOfItsVoxels(touch);
  }

  private static void assertMatterIsThatOfItsVoxels(ElasticTouch touch) {
    WindowLattice window = touch.lattice.window().orElseThrow();
    int drilled = 0;
    for (int cell = 0; cell < window.matter().cells().count(); cell++) {
      int node = window.matter().cells().firstNode(cell);
      int solid = 0;
      for (int voxel = 0; voxel < 64; voxel++) {
        int i = first(window, 0, node) + voxel % 4;
        int j = first(window, 1, node) + voxel / 4 % 4;
        int k = first(window, 2, node) + voxel / 16;
        boolean isSolid = touch.soft.get(i, j, k);
        solid += isSolid ? 1 : 0;
        boolean inBlock = i >= 16 && i < 80 && j >= 16 && j < 80 && k >= 8 && k < 48;
        drilled += inBlock && !isSolid ? 1 : 0;
      }
      assertEquals(0.02 * solid / 64, window.matter().restModulus(cell), 1e-6, "cell " + cell);
    }
    assertTrue(drilled > 100, "drilled " + drilled);
  }

  private static int first(WindowLattice window, int axis, int node) {
    return window.layout().originVoxel(axis) + 4 * window.layout().nodeIndex(axis, node);
  }

  @Test
  void framesAndUpdatesAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    ElasticTouch touch = above(16, 16);
    touch.moveTo(38.3, 48.4, 46, 100);
    long least = Long.MAX_VALUE;
    ElasticLoad load = new ElasticLoad();
    for (int round = 0; round < 5; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int n = 0; n < 1000; n++) {
        touch.hand.x = 38.3 + 20 * Math.sin(n * 0.01);
        touch.body.contact().begin(touch.hand, touch.frame.point(), NEWTON_PER_MM);
        touch.body.contact().follow(touch.solver, touch.scene, touch.frame.point(), NEWTON_PER_MM);
        if (n % 50 == 0) {
          touch.body.loads().read(load);
          touch.body.updater().update(load);
        }
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(field(touch).hasWindow());
    assertEquals(0, least);
  }

  @Test
  void refusesAContactSharperThanHalfACell() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> above(8, 3.9));
    assertEquals(
        "a contact of 3.9 mm needs cells of at most twice its radius", refused.getMessage());
  }

  @Test
  void aContactOfTwoCellsNeedsNoWindow() {
    assertTrue(above(8, 16).lattice.window().isEmpty());
    assertTrue(above(8, 20).lattice.window().isEmpty());
  }

  /** The force of a contact that is far larger than the body is spread over all of it. */
  @Test
  void aContactMayBeLargerThanTheBody() {
    ElasticTouch touch = above(8, 1e6);
    touch.moveTo(38.3, 48.4, 46, 100);
    assertTrue(touch.frame.forceNewton().z > 0.1, "pushed " + touch.frame.forceNewton());
    assertEquals(0, touch.body.counters().refused());
    assertEquals(0, TetrahedraJudge.folded(touch.lattice, touch.body.contact().map()));
  }
}
