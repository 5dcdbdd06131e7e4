package org.palpate.elastic;

/**
 * Updates an elastic body every {@link #FRAMES} frames of a millisecond, or as many more as frames
 * are shorter, between two frames of the same thread. An update uses the load of the previous
 * update, like a thread that needs the whole period. So a replay gives the same bits on every
 * machine.
 */
public final class SynchronousUpdates {
  /** The frames of a period, 30 a second at 1 kHz. */
  public static final int FRAMES = 33;

  private final ElasticBody body;
  private final ElasticLoad seen = new ElasticLoad();
  private final int framesAPeriod;
  private int frame;

  /**
   * Creates the updates of a body that no other thread updates, for frames of a millisecond.
   *
   * @param body the elastic segments
   */
  public SynchronousUpdates(ElasticBody body) {
    this(body, 1);
  }

  /**
   * Creates the updates of a body that no other thread updates.
   *
   * @param body the elastic segments
   * @param frameMs the length of a frame, ms; more than a millisecond counts as one
   */
  public SynchronousUpdates(ElasticBody body, double frameMs) {
    this.body = body;
    framesAPeriod = ElasticContact.frames(FRAMES, frameMs);
  }

  /** Updates the body if a period is over. Call it before each frame. */
  public void beforeFrame() {
    if (frame % framesAPeriod == 0) {
      if (frame > 0) {
        body.updater().update(seen);
      }
      body.loads().read(seen);
    }
    frame++;
  }
}
