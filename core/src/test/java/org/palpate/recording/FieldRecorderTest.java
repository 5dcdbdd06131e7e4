package org.palpate.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.UpdateListener;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

class FieldRecorderTest {
  private static final CellStiffness SOFT = new CellStiffness(0.25f, 0.5f, 0.1f, -0f, 0.3f);
  private static final CellStiffness EMPTY = new CellStiffness(0, Float.MIN_VALUE, 1, 1, 1);

  private final FieldRecorder recorder = new FieldRecorder();
  private final List<RecordedUpdate> read = new ArrayList<>();
  private long sample;
  private final UpdateListener listener = recorder.listener(() -> sample);

  private List<Long> frames() {
    return read.stream().map(RecordedUpdate::frame).toList();
  }

  private void update(double x) {
    listener.updating(new Vec3(x, 0.1, -0.0), new Vec3(0, 0, -x));
  }

  @Test
  void givesUpdatesWithTheFrameThatUsedThemInOrder() {
    update(0);
    update(1);
    recorder.drainTo(read::add);
    assertEquals(List.of(), read, "none is used yet");
    sample = 40;
    listener.used(1);
    update(2);
    recorder.drainTo(read::add);
    assertEquals(List.of(RecordedUpdate.UNUSED, 40L), frames());
    sample = 70;
    listener.used(2);
    update(3);
    recorder.drainTo(read::add);
    assertEquals(List.of(RecordedUpdate.UNUSED, 40L, 70L), frames());
    assertEquals(2, read.get(2).point().x);
    assertEquals(-2, read.get(2).forceNewton().z);
    assertEquals(-0.0, read.get(2).point().z);
  }

  @Test
  void givesEachUpdateTheCellsThatWereCountedBeforeIt() {
    update(0);
    listener.refilled(7, SOFT);
    listener.refilled(9, EMPTY);
    update(1);
    listener.refilled(3, SOFT);
    update(2);
    listener.used(0);
    listener.used(1);
    listener.used(2);
    recorder.drainTo(read::add);
    assertEquals(List.of(), read.get(0).refills());
    assertEquals(
        List.of(new RecordedUpdate.Refill(7, SOFT), new RecordedUpdate.Refill(9, EMPTY)),
        read.get(1).refills());
    assertEquals(List.of(new RecordedUpdate.Refill(3, SOFT)), read.get(2).refills());
    assertEquals(0, recorder.overflows());
  }

  /** A lattice of 16 x 16 x 16 cells with a window of quarter cells has this many in all. */
  @Test
  void keepsEveryCellOfAnEditOfAWholeLattice() {
    int cells = 65 * 4096;
    for (int n = 0; n < 2; n++) {
      for (int cell = 0; cell < cells; cell++) {
        listener.refilled(cell, cell % 2 == 0 ? SOFT : EMPTY);
      }
      update(n);
      listener.used(n);
    }
    recorder.drainTo(read::add);
    assertEquals(0, recorder.overflows());
    assertEquals(2, read.size());
    for (RecordedUpdate each : read) {
      assertEquals(cells, each.refills().size());
      assertEquals(new RecordedUpdate.Refill(0, SOFT), each.refills().get(0));
      assertEquals(new RecordedUpdate.Refill(cells - 1, EMPTY), each.refills().get(cells - 1));
    }
  }

  /** Nobody reads, as when the file could not be written. */
  @Test
  void updatesWithoutAReaderAreBoundedAndCountedAsLost() {
    int fit = (FieldRecorder.MOST_CELLS - 1) / FieldRecorder.CELLS_AN_UPDATE;
    for (int n = 0; n < fit + 100; n++) {
      update(n);
    }
    assertEquals(100, recorder.overflows());
    listener.used(fit - 1);
    listener.used(fit + 50);
    assertEquals(100, recorder.overflows(), "the use of a lost update is part of its loss");
    recorder.drainTo(read::add);
    assertEquals(fit, read.size());
    assertEquals(fit - 1, read.get(fit - 1).point().x);
  }

  @Test
  void cellsWithoutAReaderAreBoundedAndNoLaterUpdateIsKept() {
    int halfOfAll = FieldRecorder.MOST_CELLS / 2;
    refill(halfOfAll);
    update(0);
    refill(halfOfAll);
    update(1);
    listener.used(0);
    listener.used(1);
    recorder.drainTo(read::add);
    update(2);
    listener.used(2);
    recorder.drainTo(read::add);
    assertEquals(1, read.size(), "the second has no room, and the third continues it");
    assertEquals(halfOfAll, read.get(0).refills().size());
    assertEquals(2, recorder.overflows());
  }

  @Test
  void anEditThatHasNoRoomAtAllIsLost() {
    update(0);
    refill(FieldRecorder.MOST_CELLS + 10);
    update(1);
    listener.used(1);
    recorder.drainTo(read::add);
    assertEquals(List.of(), read, "no use of the first update is known");
    assertEquals(1, recorder.overflows());
  }

  @Test
  void aReaderThatKeepsUpLosesNothingHoweverLongTheSessionIs() {
    int rounds = 40;
    for (int n = 0; n < rounds; n++) {
      refill(FieldRecorder.MOST_CELLS / 10);
      update(n);
      listener.used(n);
      recorder.drainTo(each -> read.add(withoutCells(each)));
    }
    assertEquals(0, recorder.overflows());
    assertEquals(rounds, read.size());
  }

  private static RecordedUpdate withoutCells(RecordedUpdate update) {
    return new RecordedUpdate(update.frame(), update.point(), update.forceNewton(), List.of());
  }

  private void refill(int cells) {
    for (int cell = 0; cell < cells; cell++) {
      listener.refilled(cell, SOFT);
    }
  }

  @Test
  void aLoadThatChangesLaterStaysAsItWas() {
    Vec3 point = new Vec3(1, 2, 3);
    Vec3 force = new Vec3(0, 0, -1);
    listener.updating(point, force);
    point.x = 9;
    force.z = -9;
    listener.used(0);
    recorder.drainTo(read::add);
    assertEquals(1, read.get(0).point().x);
    assertEquals(-1, read.get(0).forceNewton().z);
  }

  @Test
  void countsTheUsesThatAFullBufferDrops() {
    for (int n = 0; n < 5000; n++) {
      update(n);
      listener.used(n);
    }
    assertEquals(5000 - 4096, recorder.overflows());
    recorder.drainTo(read::add);
    assertEquals(4096, read.size());
  }
}
