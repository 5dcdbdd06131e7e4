package org.palpate.elastic;

import java.util.List;

/**
 * Updates an elastic body as a recorded session did: the same loads, and each field in use from the
 * same frame on. So a replay gives the bits of the session. One thread.
 */
public final class RecordedUpdates {
  private final ElasticBody body;
  private final List<RecordedUpdate> recorded;
  private final ElasticLoad load = new ElasticLoad();
  private int next;
  private long frame;

  /**
   * Creates the updates of a body that no other thread updates.
   *
   * @param recorded in the order of the session
   * @throws IllegalArgumentException if the body has no such cell, so it is another one
   */
  public RecordedUpdates(ElasticBody body, List<RecordedUpdate> recorded) {
    this.body = body;
    this.recorded = List.copyOf(recorded);
    for (RecordedUpdate update : this.recorded) {
      for (RecordedUpdate.Refill refill : update.refills()) {
        if (refill.cell() < 0 || refill.cell() >= body.hexahedra()) {
          throw new IllegalArgumentException(
              "there is no cell " + refill.cell() + " among " + body.hexahedra());
        }
      }
    }
  }

  /**
   * Computes the field that comes into use in the next frame, if any. Call it before each frame.
   */
  public void beforeFrame() {
    int end = next;
    for (int n = next; n < recorded.size() && recorded.get(n).frame() <= frame; n++) {
      end = recorded.get(n).frame() == RecordedUpdate.UNUSED ? end : n + 1;
    }
    while (next < end) {
      update(recorded.get(next++));
    }
    frame++;
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
