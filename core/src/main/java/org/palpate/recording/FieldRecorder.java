package org.palpate.recording;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.UpdateListener;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

/**
 * Ring buffers of the updates of elastic segments, from the thread that computes them and from the
 * haptic thread, which uses their fields.
 *
 * <p>One writer of updates and one writer of uses. One reader, a {@link RecordingThread}. A full
 * buffer drops the newest entry and counts it.
 */
public final class FieldRecorder {
  /** The number of updates: over two minutes at the usual rate. */
  private static final int UPDATES = 1 << 12;

  /**
   * The number of cells: some fifty of the largest edits. With a fine window there are up to 64
   * short ones for each.
   */
  private static final int REFILLS = 1 << 16;

  private static final int WORDS_AN_UPDATE = 6;
  private static final int WORDS_A_REFILL = 5;
  private static final int WORDS_A_USE = 2;

  private final WordRing updates = new WordRing(UPDATES, WORDS_AN_UPDATE);
  private final WordRing refills = new WordRing(REFILLS, WORDS_A_REFILL);
  private final WordRing uses = new WordRing(UPDATES, WORDS_A_USE);

  /** The number of the next update. Writer of updates. */
  private long writing;

  /** Updates that were read, and whether they were used is not known yet. Reader. */
  private final Deque<RecordedUpdate> waiting = new ArrayDeque<>();

  /** The numbers of the first that waits, and of the next that is read. Reader. */
  private long firstWaiting;

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
        offerRefill(cell, stiffness);
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

  private void offerRefill(int cell, CellStiffness stiffness) {
    int from = refills.claim();
    if (from == WordRing.FULL) {
      return;
    }
    refills.set(from, writing);
    refills.set(from + 1, cell);
    refills.set(from + 2, pair(stiffness.solidModulus(), stiffness.restModulus()));
    refills.set(from + 3, pair(stiffness.momentX(), stiffness.momentY()));
    refills.set(from + 4, pair(stiffness.momentZ(), 0));
    refills.publish();
  }

  private static long pair(float high, float low) {
    return (long) Float.floatToRawIntBits(high) << Integer.SIZE
        | Integer.toUnsignedLong(Float.floatToRawIntBits(low));
  }

  private float high(int at) {
    return Float.intBitsToFloat((int) (refills.get(at) >>> Integer.SIZE));
  }

  private float low(int at) {
    return Float.intBitsToFloat((int) refills.get(at));
  }

  private void offerUpdate(Vec3 point, Vec3 forceNewton) {
    writing++;
    int from = updates.claim();
    if (from == WordRing.FULL) {
      return;
    }
    updates.set(from, point);
    updates.set(from + 3, forceNewton);
    updates.publish();
  }

  private void offerUse(long sample, long update) {
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
   * <p>A field is used after its update was added, so uses are counted first.
   *
   * @param sink receives each update with the frame that first used it, or with {@link
   *     RecordedUpdate#UNUSED}
   */
  public void drainTo(Consumer<RecordedUpdate> sink) {
    int used = uses.available();
    readUpdates();
    for (; used > 0; used--) {
      int from = uses.oldest();
      long update = uses.get(from + 1);
      while (firstWaiting <= update && !waiting.isEmpty()) {
        long frame = firstWaiting == update ? uses.get(from) : RecordedUpdate.UNUSED;
        sink.accept(withFrame(waiting.remove(), frame));
        firstWaiting++;
      }
      uses.release();
    }
  }

  private static RecordedUpdate withFrame(RecordedUpdate update, long frame) {
    return new RecordedUpdate(frame, update.point(), update.forceNewton(), update.refills());
  }

  private void readUpdates() {
    for (int left = updates.available(); left > 0; left--) {
      int from = updates.oldest();
      waiting.add(
          new RecordedUpdate(RecordedUpdate.UNUSED, vector(from), vector(from + 3), readRefills()));
      updates.release();
      reading++;
    }
  }

  private Vec3 vector(int from) {
    Vec3 vector = new Vec3();
    updates.get(from, vector);
    return vector;
  }

  /** Reads the cells that belong to the update that is read. */
  private List<RecordedUpdate.Refill> readRefills() {
    List<RecordedUpdate.Refill> cells = new ArrayList<>();
    for (int left = refills.available(); left > 0; left--) {
      int from = refills.oldest();
      if (refills.get(from) != reading) {
        break;
      }
      CellStiffness stiffness =
          new CellStiffness(
              high(from + 2), low(from + 2), high(from + 3), low(from + 3), high(from + 4));
      cells.add(new RecordedUpdate.Refill((int) refills.get(from + 1), stiffness));
      refills.release();
    }
    return cells;
  }

  /** {@return the number of entries that were dropped because a buffer was full} Any thread. */
  public long overflows() {
    return updates.overflows() + refills.overflows() + uses.overflows();
  }
}
