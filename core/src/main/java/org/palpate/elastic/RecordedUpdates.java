package org.palpate.elastic;

import java.util.List;

/**
 * Updates an elastic body as a recorded session did: the same loads, and each field in use from the
 * same frame on. So a replay gives the bits of the session. One thread.
 *
 * <p>Each load is that of a frame of the session. {@link UpdateCounters#elsewhere} counts those
 * that no frame of the replay reached before the field came into use.
 */
public final class RecordedUpdates {
  private final ElasticBody body;
  private final List<RecordedUpdate> recorded;
  private final ElasticLoad load = new ElasticLoad();
  private int next;

  /** The next update whose load is to be reached. */
  private int awaited;

  private long frame;

  /**
   * Creates the updates of a body that no other thread updates.
   *
   * @param body the elastic segments at rest, as the session had them
   * @param recorded in the order of the session
   * @throws IllegalArgumentException if the body has no such cell, so it is another one
   */
  public RecordedUpdates(ElasticBody body, List<RecordedUpdate> recorded) {
    this.body = body;
    this.recorded = List.copyOf(recorded);
    for (RecordedUpdate update : this.recorded) {
      for (RecordedUpdate.Refill refill : update.refills()) {
        int last = body.lattice().refillCells() - 1;
        if (refill.cell() < 0 || refill.cell() > last) {
          throw new IllegalArgumentException(
              "an update sets cell " + refill.cell() + ", but cells are 0 to " + last);
        }
      }
    }
  }

  /**
   * Computes the field that comes into use in the next frame, if any. Call it before each frame.
   */
  public void beforeFrame() {
    passReachedLoads();
    int end = next;
    for (int n = next; n < recorded.size() && recorded.get(n).frame() <= frame; n++) {
      end = recorded.get(n).frame() == RecordedUpdate.UNUSED ? end : n + 1;
    }
    while (next < end) {
      if (awaited == next) {
        body.counters().countElsewhere();
        awaited++;
        passReachedLoads();
      }
      update(recorded.get(next++));
    }
    frame++;
  }

  /** Passes over the updates with the load of the last frame; several may have the same one. */
  private void passReachedLoads() {
    ElasticLoad last = body.contact().load();
    while (awaited < recorded.size() && last.isOf(recorded.get(awaited))) {
      awaited++;
    }
  }

  private void update(RecordedUpdate update) {
    for (RecordedUpdate.Refill refill : update.refills()) {
      body.lattice().refill(refill.cell(), refill.stiffness());
    }
    load.point.set(update.point());
    load.forceNewton.set(update.forceNewton());
    body.updater().compute(load);
  }
}
