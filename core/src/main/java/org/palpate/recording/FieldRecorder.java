package org.palpate.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.UpdateListener;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

/**
 * Buffers of the updates of elastic segments, from the thread that computes them and from the
 * haptic thread, which uses their fields.
 *
 * <p>One writer of updates, which may allocate: a large edit changes every cell of a lattice, and
 * with a fine window 64 short ones in each. One writer of uses, which neither waits nor allocates;
 * its ring buffer, if full, drops the newest use and counts it. One reader, a {@link
 * RecordingThread}.
 *
 * <p>The updates are bounded too, because the reader may be slow, or may stop when its file cannot
 * be written. From the first update on that has no room, none is kept, because each continues those
 * before it. All of them count as lost.
 */
public final class FieldRecorder {
  /** The number of uses that fit: over two minutes at the usual rate. */
  private static final int USES = 1 << 12;

  private static final int WORDS_A_USE = 2;

  /**
   * The most cells of updates that wait for the reader: nearly eight edits of a whole lattice with
   * a fine window, or hours of updates without an edit. They take about 64 bytes each.
   */
  static final int MOST_CELLS = 1 << 21;

  /** The cells for which an update without any counts, by its memory. */
  static final int CELLS_AN_UPDATE = 4;

  private static final long NOTHING_LOST = Long.MAX_VALUE;

  /** The updates that are not read yet. */
  private final Queue<RecordedUpdate> updates = new ConcurrentLinkedQueue<>();

  /** The cells of these updates. Writer of updates and reader. */
  private final AtomicInteger waitingCells = new AtomicInteger();

  private final WordRing uses = new WordRing(USES, WORDS_A_USE);

  /** The cells of the next update. Writer of updates. */
  private List<RecordedUpdate.Refill> refills = new ArrayList<>();

  /** The number of updates so far. Writer of updates. */
  private long offered;

  /** The number of the first update that was lost. Writer of updates. */
  private volatile long firstLost = NOTHING_LOST;

  /** The number of updates that were lost. Writer of updates. */
  private volatile long lost;

  /** The number of the next update that is read. Reader. */
  private long reading;

  /**
   * {@return what adds the updates of a body to the buffers}
   *
   * @param sampleOfChanges returns the number of the device sample, from 0, with which a replay
   *     uses a field that the present frame takes; called by the haptic thread
   */
  public UpdateListener listener(LongSupplier sampleOfChanges) {
    return new UpdateListener() {
      @Override
      public void refilled(int cell, CellStiffness stiffness) {
        if (hasRoom()) {
          refills.add(new RecordedUpdate.Refill(cell, stiffness));
        } else {
          loseFromNowOn();
        }
      }

      @Override
      public void updating(Vec3 point, Vec3 forceNewton) {
        offerUpdate(point, forceNewton);
      }

      @Override
      public void used(long update) {
        offerUse(sampleOfChanges.getAsLong(), update);
      }
    };
  }

  /** Whether the next update has room with one cell more. Writer of updates. */
  private boolean hasRoom() {
    return firstLost == NOTHING_LOST
        && waitingCells.get() + CELLS_AN_UPDATE + refills.size() < MOST_CELLS;
  }

  /** Keeps neither the next update nor any after it. Writer of updates. */
  private void loseFromNowOn() {
    if (firstLost == NOTHING_LOST) {
      firstLost = offered;
      refills = new ArrayList<>();
    }
  }

  private void offerUpdate(Vec3 point, Vec3 forceNewton) {
    if (hasRoom()) {
      Vec3 at = new Vec3().set(point);
      Vec3 force = new Vec3().set(forceNewton);
      waitingCells.addAndGet(cells(refills));
      updates.add(new RecordedUpdate(RecordedUpdate.UNUSED, at, force, refills));
      refills = new ArrayList<>();
    } else {
      loseFromNowOn();
      countLost();
    }
    offered++;
  }

  @SuppressWarnings("NonAtomicVolatileUpdate") // one writer
  private void countLost() {
    lost++;
  }

  private static int cells(List<RecordedUpdate.Refill> refills) {
    return CELLS_AN_UPDATE + refills.size();
  }

  private void offerUse(long sample, long update) {
    if (update >= firstLost) {
      return; // The update itself counts as lost.
    }
    int from = uses.claim();
    if (from == WordRing.FULL) {
      return;
    }
    uses.set(from, sample);
    uses.set(from + 1, update);
    uses.publish();
  }

  /**
   * Moves updates up to the last one that was used into a sink, in their order. Reader.
   *
   * <p>A field is used after its update was added, so the update of each use is there. A use of an
   * update that was lost is not kept.
   *
   * @param sink receives each update with the frame that first used it, or with {@link
   *     RecordedUpdate#UNUSED}
   */
  public void drainTo(Consumer<RecordedUpdate> sink) {
    for (int used = uses.available(); used > 0; used--) {
      int from = uses.oldest();
      long sample = uses.get(from);
      long update = uses.get(from + 1);
      uses.release();
      for (; reading <= update; reading++) {
        long frame = reading == update ? sample : RecordedUpdate.UNUSED;
        RecordedUpdate next = updates.remove();
        waitingCells.addAndGet(-cells(next.refills()));
        sink.accept(withFrame(next, frame));
      }
    }
  }

  private static RecordedUpdate withFrame(RecordedUpdate update, long frame) {
    return new RecordedUpdate(frame, update.point(), update.forceNewton(), update.refills());
  }

  /**
   * {@return the number of updates that were lost, and of uses that were dropped, because their
   * buffer was full} Any thread.
   */
  public long overflows() {
    return lost + uses.overflows();
  }
}
