package org.palpate.sync;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

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
 * <p>Wait-free for the writer: plain stores between two stores of a sequence number, whatever the
 * reader does. The last value of a property wins; a value that did not change is not written; all
 * that one {@link #publish} carries arrives together, so position and force are of the same frame.
 * The reader takes a copy and throws it away where the sequence moved meanwhile; after {@value
 * #MOST_TRIES} tries it leaves it for its next turn. A property stays dirty until the reader called
 * {@link Property#applied}, so that a renderer which threw is asked again.
 *
 * <p>One writer: the haptic thread sets and publishes, soon after each other. One reader: the
 * synchronization thread takes, reads and applies. Properties are made before either starts.
 * Nothing is allocated after.
 *
 * <p>Cost of a write: measured by {@code palpate bench --sync}. A triple buffer, which would be
 * wait-free for the reader too, took more than twice the time: its atomic exchange and its copies
 * are the haptic thread's. Source of the task: Vlasov et al. 2013, section 5.2, which used
 * synchronized statements; of the sequence: Boehm, "Can seqlocks get along with programming
 * language memory models?", MSPC 2012.
 */
public final class Accumulator {
  /** How often the reader begins anew where the writer was faster. */
  static final int MOST_TRIES = 64;

  private static final VarHandle SEQUENCE;

  static {
    try {
      SEQUENCE = MethodHandles.lookup().findVarHandle(Accumulator.class, "sequence", long.class);
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  private final boolean skipsUnchanged;
  private final List<Property> properties = new ArrayList<>();
  private boolean started;

  // Written between an odd and an even sequence number, read between two that are the same.
  private long[] words = new long[0];
  private long stamp;

  /** Changes of each property: a count of its own each, since one for all would be waited for. */
  private long[] writes = new long[0];

  /** Odd while values are being set. */
  @SuppressWarnings("unused") // by its handle
  private long sequence;

  // The writer's.
  private boolean open;
  private long writerSequence;
  private long unchanged;

  // The reader's.
  private long[] copy = new long[0];
  private long[] copiedWrites = new long[0];
  private long[] seenWrites = new long[0];
  private long[] taken = new long[0];
  private boolean[] pending = new boolean[0];
  private long copiedStamp;
  private long seenStamp;
  private long applied;

  /** Writes what changed, and nothing else. */
  public Accumulator() {
    this(true);
  }

  /**
   * An accumulator with a choice, to see what it is worth.
   *
   * @param skipsUnchanged whether a value that did not change is left out, or written all the same,
   *     handed over and applied
   */
  public Accumulator(boolean skipsUnchanged) {
    this.skipsUnchanged = skipsUnchanged;
  }

  /** Makes a position, three doubles. Before the first publication only, as all that follow. */
  public PositionProperty position(String name) {
    return add(new PositionProperty(this, name, properties.size(), words.length));
  }

  /** Makes a rigid transform. */
  public TransformProperty transform(String name) {
    return add(new TransformProperty(this, name, properties.size(), words.length));
  }

  /** Makes a single number. */
  public NumberProperty number(String name) {
    return add(new NumberProperty(this, name, properties.size(), words.length));
  }

  /** Makes a colour. */
  public ColourProperty colour(String name) {
    return add(new ColourProperty(this, name, properties.size(), words.length));
  }

  /** Makes a switch that shows or hides; it starts hidden. */
  public VisibilityProperty visibility(String name) {
    return add(new VisibilityProperty(this, name, properties.size(), words.length));
  }

  /** Makes a polyline of at most {@code capacity} points. */
  public LinesProperty lines(String name, int capacity) {
    return add(new LinesProperty(this, name, properties.size(), words.length, capacity));
  }

  /** Makes a place for what a haptic frame has to show. */
  public TouchProperty touch(String name) {
    return add(new TouchProperty(this, name, properties.size(), words.length));
  }

  /** Makes a text of at most {@code capacity} chars. */
  public TextProperty text(String name, int capacity) {
    return add(new TextProperty(this, name, properties.size(), words.length, capacity));
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
    int length = words.length + property.words();
    words = new long[length];
    copy = new long[length];
    taken = new long[length];
    writes = new long[properties.size()];
    copiedWrites = new long[properties.size()];
    seenWrites = new long[properties.size()];
    pending = new boolean[properties.size()];
    return property;
  }

  /** Whether anything was changed since the last publication. Writer. */
  public boolean isDirty() {
    return open;
  }

  /**
   * Hands everything that was set since the last call to the reader, as one. Writer. Costs nothing
   * where nothing changed, else one store.
   */
  public void publish() {
    if (open) {
      started = true;
      stamp++;
      open = false;
      SEQUENCE.setRelease(this, ++writerSequence);
    } else {
      unchanged++;
    }
  }

  /** Writer: from here to the publication the reader keeps away. */
  private void open() {
    open = true;
    SEQUENCE.setOpaque(this, ++writerSequence);
    VarHandle.storeStoreFence();
  }

  boolean put(int offset, long word) {
    if (words[offset] == word && skipsUnchanged) {
      return false;
    }
    if (!open) {
      open();
    }
    words[offset] = word;
    return true;
  }

  /** Three words in a row, the most frequent case; whether any differed. */
  boolean put(int offset, long a, long b, long c) {
    long[] into = words;
    if (into[offset] == a && into[offset + 1] == b && into[offset + 2] == c && skipsUnchanged) {
      return false;
    }
    if (!open) {
      open();
    }
    into[offset] = a;
    into[offset + 1] = b;
    into[offset + 2] = c;
    return true;
  }

  /**
   * The eleven words of a {@link TouchProperty}, all in one go: whether any but the last differed.
   * Written out, since a loop over them takes longer than all the rest.
   */
  boolean putTouch(int offset, Vec3 device, Vec3 point, Vec3 force, long contact, long frame) {
    long[] into = words;
    long deviceX = Double.doubleToRawLongBits(device.x);
    long deviceY = Double.doubleToRawLongBits(device.y);
    long deviceZ = Double.doubleToRawLongBits(device.z);
    long pointX = Double.doubleToRawLongBits(point.x);
    long pointY = Double.doubleToRawLongBits(point.y);
    long pointZ = Double.doubleToRawLongBits(point.z);
    long forceX = Double.doubleToRawLongBits(force.x);
    long forceY = Double.doubleToRawLongBits(force.y);
    long forceZ = Double.doubleToRawLongBits(force.z);
    long differs =
        (into[offset] ^ deviceX)
            | (into[offset + 1] ^ deviceY)
            | (into[offset + 2] ^ deviceZ)
            | (into[offset + 3] ^ pointX)
            | (into[offset + 4] ^ pointY)
            | (into[offset + 5] ^ pointZ)
            | (into[offset + 6] ^ forceX)
            | (into[offset + 7] ^ forceY)
            | (into[offset + 8] ^ forceZ)
            | (into[offset + 9] ^ contact);
    if (differs == 0 && skipsUnchanged) {
      return false;
    }
    if (!open) {
      open();
    }
    into[offset] = deviceX;
    into[offset + 1] = deviceY;
    into[offset + 2] = deviceZ;
    into[offset + 3] = pointX;
    into[offset + 4] = pointY;
    into[offset + 5] = pointZ;
    into[offset + 6] = forceX;
    into[offset + 7] = forceY;
    into[offset + 8] = forceZ;
    into[offset + 9] = contact;
    into[offset + 10] = frame;
    return true;
  }

  void changed(Property property) {
    writes[property.index()]++;
  }

  /**
   * Takes the newest publication, where there is one. Reader.
   *
   * @return whether any property is dirty, by this call or because it was not applied before
   */
  public boolean take() {
    for (int tries = 0; tries < MOST_TRIES; tries++) {
      if (copyAll()) {
        keepCopy();
        break;
      }
      Thread.onSpinWait();
    }
    return anyPending();
  }

  /** Whether the copy is of one publication. */
  private boolean copyAll() {
    long before = (long) SEQUENCE.getAcquire(this);
    if ((before & 1) != 0) {
      return false;
    }
    System.arraycopy(words, 0, copy, 0, copy.length);
    System.arraycopy(writes, 0, copiedWrites, 0, copiedWrites.length);
    copiedStamp = stamp;
    VarHandle.loadLoadFence();
    return (long) SEQUENCE.getOpaque(this) == before;
  }

  private void keepCopy() {
    for (int i = 0; i < pending.length; i++) {
      pending[i] |= copiedWrites[i] != seenWrites[i];
      seenWrites[i] = copiedWrites[i];
    }
    seenStamp = copiedStamp;
    long[] old = taken;
    taken = copy;
    copy = old;
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
  public SyncCounters counts() {
    long writesSeen = 0;
    for (long ofProperty : seenWrites) {
      writesSeen += ofProperty;
    }
    return new SyncCounters(writesSeen, unchanged, seenStamp, applied);
  }

  long taken(int offset) {
    return taken[offset];
  }

  boolean isPending(Property property) {
    return pending[property.index()];
  }

  void markApplied(Property property) {
    pending[property.index()] = false;
    applied++;
  }
}
