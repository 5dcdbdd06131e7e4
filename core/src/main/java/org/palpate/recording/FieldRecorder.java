package org.palpate.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
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
 */
public final class FieldRecorder {
  /** The number of uses that fit: over two minutes at the usual rate. */
  private static final int USES = 1 << 12;

  private static final int WORDS_A_USE = 2;

  /** The updates that are not read yet. */
  private final Queue<RecordedUpdate> updates = new ConcurrentLinkedQueue<>();

  private final WordRing uses = new WordRing(USES, WORDS_A_USE);

  /** The cells of the next update. Writer of updates. */
  private List<RecordedUpdate.Refill> refills = new ArrayList<>();

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
        refills.add(new RecordedUpdate.Refill(cell, stiffness));
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

  private void offerUpdate(Vec3 point, Vec3 forceNewton) {
    Vec3 at = new Vec3().set(point);
    Vec3 force = new Vec3().set(forceNewton);
    updates.add(new RecordedUpdate(RecordedUpdate.UNUSED, at, force, refills));
    refills = new ArrayList<>();
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
   * <p>A field is used after its update was added, so the update of each use is there.
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
        sink.accept(withFrame(updates.remove(), frame));
      }
    }
  }

  private static RecordedUpdate withFrame(RecordedUpdate update, long frame) {
    return new RecordedUpdate(frame, update.point(), update.forceNewton(), update.refills());
  }

  /** {@return the number of uses that were dropped because their buffer was full} Any thread. */
  public long overflows() {
    return uses.overflows();
  }
}
