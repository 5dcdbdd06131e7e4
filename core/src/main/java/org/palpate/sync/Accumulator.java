package org.palpate.sync;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Collects changes of scene properties in the haptic thread and hands them, a whole frame at a
 * time, to the synchronization thread.
 *
 * <pre>
 *   set up      Accumulator scene = new Accumulator();
 *               PositionProperty tip = scene.position("tip");
 *   writer      tip.set(x, y, z); ...; scene.publish();          once a frame
 *   reader      if (scene.take()) {                              at 30 Hz
 *                 if (tip.isDirty()) { tip.read(vec); node.move(vec); tip.applied(); }
 *               }
 * </pre>
 *
 * <p>Wait-free for both: a publication is one atomic exchange, whatever the other side does. The
 * last value of a property wins; a value that did not change is not written; all that one {@link
 * #publish} carries arrives together, so position and force are of the same frame. A property stays
 * dirty until the reader called {@link Property#applied}, so that a renderer which threw is asked
 * again.
 *
 * <p>One writer: the haptic thread sets and publishes. One reader: the synchronization thread
 * takes, reads and applies. Properties are made before either starts. Nothing is allocated after.
 *
 * <p>Three buffers go round: one the writer's, one the reader's, one in the middle. Invariant: the
 * master holds the last value of every property, and {@code stale} of a buffer says where it
 * differs from the master. Source of the task: Vlasov et al. 2013, section 5.2, which used
 * synchronized statements.
 */
public final class Accumulator {
  private static final int BUFFERS = 3;
  private static final int INDEX_MASK = 3;
  private static final int FRESH = 4;

  private static final class Buffer {
    long[] words = new long[0];
    long[] stamps = new long[0];
    long[] stale = new long[0];
    long stamp;
    long writes;
  }

  private final List<Property> properties = new ArrayList<>();
  private final Buffer[] buffers = {new Buffer(), new Buffer(), new Buffer()};
  private final AtomicInteger middle = new AtomicInteger(1);
  private boolean started;

  // The writer's.
  private long[] master = new long[0];
  private long[] dirty = new long[0];
  private boolean anyDirty;
  private int back;
  private long stamp;
  private long writes;

  // The reader's.
  private int front = 2;
  private boolean[] pending = new boolean[0];
  private long seenStamp;
  private long applied;

  /** Makes a position, three doubles. Before the first publication only, as all that follow. */
  public PositionProperty position(String name) {
    return add(new PositionProperty(this, name, properties.size(), master.length));
  }

  /** Makes a rigid transform. */
  public TransformProperty transform(String name) {
    return add(new TransformProperty(this, name, properties.size(), master.length));
  }

  /** Makes a single number. */
  public NumberProperty number(String name) {
    return add(new NumberProperty(this, name, properties.size(), master.length));
  }

  /** Makes a colour. */
  public ColourProperty colour(String name) {
    return add(new ColourProperty(this, name, properties.size(), master.length));
  }

  /** Makes a switch that shows or hides; it starts hidden. */
  public VisibilityProperty visibility(String name) {
    return add(new VisibilityProperty(this, name, properties.size(), master.length));
  }

  /** Makes a polyline of at most {@code capacity} points. */
  public LinesProperty lines(String name, int capacity) {
    return add(new LinesProperty(this, name, properties.size(), master.length, capacity));
  }

  /** Makes a text of at most {@code capacity} chars. */
  public TextProperty text(String name, int capacity) {
    return add(new TextProperty(this, name, properties.size(), master.length, capacity));
  }

  /** The properties in the order in which they were made. */
  public List<Property> properties() {
    return List.copyOf(properties);
  }

  private <P extends Property> P add(P property) {
    if (started) {
      throw new IllegalStateException(
          "properties are made before the first publication: property=" + property.name());
    }
    properties.add(property);
    int words = master.length + property.words();
    int masks = (properties.size() + 63) >> 6;
    master = new long[words];
    dirty = new long[masks];
    pending = new boolean[properties.size()];
    for (Buffer buffer : buffers) {
      buffer.words = new long[words];
      buffer.stamps = new long[properties.size()];
      buffer.stale = new long[masks];
    }
    return property;
  }

  /** Whether anything was changed since the last publication. Writer. */
  public boolean isDirty() {
    return anyDirty;
  }

  /**
   * Hands everything that was set since the last call to the reader, as one. Writer. Costs nothing
   * where nothing changed, else one atomic exchange and a copy of what changed.
   */
  public void publish() {
    if (!anyDirty) {
      return;
    }
    started = true;
    stamp++;
    for (int mask = 0; mask < dirty.length; mask++) {
      for (int buffer = 0; buffer < BUFFERS; buffer++) {
        buffers[buffer].stale[mask] |= dirty[mask];
      }
      dirty[mask] = 0;
    }
    anyDirty = false;
    refresh(buffers[back]);
    back = middle.getAndSet(back | FRESH) & INDEX_MASK;
  }

  /** Brings a buffer that went round up to the master. */
  private void refresh(Buffer buffer) {
    for (int mask = 0; mask < buffer.stale.length; mask++) {
      for (long rest = buffer.stale[mask]; rest != 0; rest &= rest - 1) {
        Property property = properties.get((mask << 6) + Long.numberOfTrailingZeros(rest));
        int from = property.offset();
        System.arraycopy(master, from, buffer.words, from, property.words());
        buffer.stamps[property.index()] = property.stamp;
      }
      buffer.stale[mask] = 0;
    }
    buffer.stamp = stamp;
    buffer.writes = writes;
  }

  /**
   * Takes the newest publication, where there is one. Reader.
   *
   * @return whether any property is dirty, by this call or because it was not applied before
   */
  public boolean take() {
    if ((middle.get() & FRESH) != 0) {
      front = middle.getAndSet(front) & INDEX_MASK;
      Buffer buffer = buffers[front];
      for (int i = 0; i < pending.length; i++) {
        pending[i] |= buffer.stamps[i] > seenStamp;
      }
      seenStamp = buffer.stamp;
    }
    return anyPending();
  }

  private boolean anyPending() {
    for (boolean one : pending) {
      if (one) {
        return true;
      }
    }
    return false;
  }

  /** The numbers of what the reader has taken so far. Reader, or anyone after both have ended. */
  public SyncCounts counts() {
    return new SyncCounts(buffers[front].writes, buffers[front].stamp, applied);
  }

  boolean put(int offset, long word) {
    if (master[offset] == word) {
      return false;
    }
    master[offset] = word;
    return true;
  }

  void changed(Property property) {
    dirty[property.index() >> 6] |= 1L << property.index();
    property.stamp = stamp + 1;
    anyDirty = true;
    writes++;
  }

  long taken(int offset) {
    return buffers[front].words[offset];
  }

  boolean isPending(Property property) {
    return pending[property.index()];
  }

  void markApplied(Property property) {
    pending[property.index()] = false;
    applied++;
  }
}
