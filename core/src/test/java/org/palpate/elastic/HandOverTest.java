package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class HandOverTest {
  private final Random random = new Random(Seeds.seed());
  private final BitCube bits = new BitCube(20, 20, 20);
  private final ControlLattice lattice = ElasticTouch.softCube(bits, 2, new GridMetric(1, 1, 1), 5);

  @Test
  void theReaderTakesTheNewestFieldOnce() {
    FieldExchange exchange = new FieldExchange(DeformationField.Layout.of(lattice));
    assertFalse(exchange.hasNew());
    DeformationField first = exchange.back();
    exchange.publish();
    DeformationField second = exchange.back();
    assertNotSame(first, second);
    exchange.publish();
    assertTrue(exchange.hasNew());
    exchange.take();
    assertSame(second, exchange.front());
    assertFalse(exchange.hasNew());
    exchange.take();
    assertSame(second, exchange.front());
    assertNotSame(second, exchange.back());
  }

  @Test
  void theWriterNeverWritesTheFieldOfTheReader() {
    FieldExchange exchange = new FieldExchange(DeformationField.Layout.of(lattice));
    for (int n = 0; n < 1000; n++) {
      if (random.nextBoolean()) {
        exchange.publish();
      } else {
        exchange.take();
      }
      assertNotSame(exchange.front(), exchange.back());
    }
  }

  @Test
  void aLoadArrivesWholeWhileAnotherThreadWritesIt() throws InterruptedException {
    ElasticLoad.Exchange exchange = new ElasticLoad.Exchange();
    List<String> torn = new ArrayList<>();
    Thread reader =
        new Thread(
            () -> {
              ElasticLoad load = new ElasticLoad();
              for (int n = 0; n < 200_000; n++) {
                exchange.read(load);
                double x = load.point.x;
                if (load.point.y != x || load.forceNewton.x != x || load.forceNewton.z != x) {
                  torn.add(load.point + " " + load.forceNewton);
                }
              }
            });
    reader.start();
    ElasticLoad load = new ElasticLoad();
    for (int n = 0; reader.isAlive(); n++) {
      load.point.set(n, n, n);
      load.forceNewton.set(n, n, n);
      exchange.write(load);
    }
    reader.join();
    assertEquals(List.of(), torn);
  }

  /** The plain reference marks the cell of each voxel of the box. */
  @Test
  void marksTheCellsOfEveryVoxelOfABox() {
    for (int n = 0; n < 200; n++) {
      ChangedCells changed = new ChangedCells(lattice);
      IntBox box = new IntBox();
      box.include(random.nextInt(30) - 5, random.nextInt(30) - 5, random.nextInt(30) - 5);
      box.include(random.nextInt(30) - 5, random.nextInt(30) - 5, random.nextInt(30) - 5);
      List<Integer> expected = new ArrayList<>();
      for (int k = box.lowZ; k <= box.highZ; k++) {
        for (int j = box.lowY; j <= box.highY; j++) {
          for (int i = box.lowX; i <= box.highX; i++) {
            int cell = lattice.editedCell(i, j, k);
            if (cell >= 0 && !expected.contains(cell)) {
              expected.add(cell);
            }
          }
        }
      }
      float[] before = moduli();
      bits.clear(2 + n % 16, 2 + n / 16 % 16, 3);
      IntBox all = new IntBox();
      changed.mark(all); // An empty box marks nothing.
      changed.mark(box);
      changed.refill(UpdateListener.NONE);
      float[] now = moduli();
      for (int cell = 0; cell < now.length; cell++) {
        if (!expected.contains(cell)) {
          assertEquals(before[cell], now[cell], "cell " + cell + " of " + box);
        }
      }
      refillAll();
      float[] full = moduli();
      for (int cell : expected) {
        assertEquals(full[cell], now[cell], "cell " + cell + " of " + box);
      }
    }
  }

  private void refillAll() {
    for (int cell = 0; cell < lattice.cells().count(); cell++) {
      lattice.refill(cell);
    }
  }

  private float[] moduli() {
    float[] moduli = new float[lattice.cells().count()];
    for (int cell = 0; cell < moduli.length; cell++) {
      moduli[cell] = lattice.matter().restModulus(cell);
    }
    return moduli;
  }
}
