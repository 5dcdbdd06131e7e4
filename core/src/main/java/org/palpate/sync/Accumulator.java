package org.palpate.sync;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * Collects changes of scene properties in the haptic thread and passes them, a whole frame at a
 * time, to the synchronization thread.
 *
 * <pre>
 *   set up      Accumulator scene = new Accumulator();
 *               PositionProperty tip = scene.position("tip");
 *   writer      tip.set(x, y, z); ...; scene.publish();          once a frame
 *   reader      if (scene.take()) {                              at 30 Hz
 *                 if (tip.isDirty()) { tip.read(vec); node.move(vec); tip.markApplied(); }
 *               }
 * </pre>
 *
 * <p>One writer: the haptic thread sets and publishes. One reader: the synchronization thread
 * takes, reads and applies. All properties are made before either starts; nothing is allocated
 * afterwards.
 *
 * <p>The writer is wait-free: it makes plain stores between two stores of a sequence number. The
 * reader copies all values and discards the copy if the sequence number changed meanwhile. After
 * {@value #MAX_TRIES} tries it waits for its next turn. The writer therefore publishes soon after
 * it has set the first value.
 *
 * <p>The last value of a property wins, and an unchanged value is not written. All values of one
 * {@link #publish} arrive together, so position and force are of the same frame. A property stays
 * dirty until the reader calls {@link Property#markApplied}, so that a renderer that threw gets the
 * value again.
 *
 * <p>Cost of a write: see {@code palpate bench --sync}. A triple buffer is wait-free for the reader
 * too, but takes more than twice the time: its atomic exchange and its copies burden the haptic
 * thread.
 *
 * <p>Sources: Vlasov et al. 2013, section 5.2, for the task, which they solve by synchronized
 * statements; Boehm, "Can seqlocks get along with programming language memory models?", MSPC 2012,
 * for the sequence number.
 */
public final class Accumulator {
  /** The number of copies that the reader tries to make in one turn. */
  static final int MAX_TRIES = 64;

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

  // The writer stores these between an odd and an even sequence number; the reader copies them
  // between two equal ones.
  private long[] words = new long[0];
  private long stamp;

  /** Counts the changes of each property. One counter for all would make each change wait. */
  private long[] writes = new long[0];

  /** Odd while the writer sets values. */
  @SuppressWarnings("unused") // accessed through its handle
  private long sequence;

  // The writer alone uses these.
  private boolean open;
  private long writerSequence;
  private long unchanged;

  // The reader alone uses these.
  private long[] copy = new long[0];
  private long[] copiedWrites = new long[0];
  private long[] seenWrites = new long[0];
  private long[] taken = new long[0];
  private boolean[] pending = new boolean[0];
  private long copiedStamp;
  private long seenStamp;
  private long applied;

  /** Makes an accumulator that skips unchanged values. */
  public Accumulator() {
    this(true);
  }

  private Accumulator(boolean skipsUnchanged) {
    this.skipsUnchanged = skipsUnchanged;
  }

  /**
   * {@return an accumulator that publishes unchanged values too, to measure what skipping saves}
   */
  public static Accumulator withoutSkipping() {
    return new Accumulator(false);
  }

  /**
   * {@return a new property of three doubles} Call it before the first publication.
   *
   * @param name the name of the property, for messages
   */
  public PositionProperty position(String name) {
    return add(new PositionProperty(this, name, properties.size(), words.length));
  }

  /**
   * {@return a new property that is a rigid transform} Call it before the first publication.
   *
   * @param name the name of the property, for messages
   */
  public TransformProperty transform(String name) {
    return add(new TransformProperty(this, name, properties.size(), words.length));
  }

  /**
   * {@return a new property that is a single number} Call it before the first publication.
   *
   * @param name the name of the property, for messages
   */
  public NumberProperty number(String name) {
    return add(new NumberProperty(this, name, properties.size(), words.length));
  }

  /**
   * {@return a new property that is the result of a haptic frame} Call it before the first
   * publication.
   *
   * @param name the name of the property, for messages
   */
  public TouchProperty touch(String name) {
    return add(new TouchProperty(this, name, properties.size(), words.length));
  }

  /** {@return the properties in the order in which they were made} */
  public List<Property> properties() {
    return List.copyOf(properties);
  }

  private <P extends Property> P add(P property) {
    if (started) {
      throw new IllegalStateException(
          "a property must be made before the first publication: property=" + property.name());
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

  /** {@return whether any value changed after the last publication} Writer. */
  public boolean isDirty() {
    return open;
  }

  /**
   * Publishes all values that were set after the last call, together. Writer. It costs one store,
   * or nothing if no value changed.
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

  /** Makes the reader discard its copies until the next publication. Writer. */
  private void open() {
    open = true;
    SEQUENCE.setOpaque(this, ++writerSequence);
    VarHandle.storeStoreFence();
  }

  /** Writes a word and returns whether it was written. Writer. */
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

  /** Writes three words in a row, the most frequent case, and returns whether it did. Writer. */
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
   * Writes the eleven words of a {@link TouchProperty}, if any but the last differs, and returns
   * whether it did. Writer. There is no loop, because a loop takes longer than all the rest; see
   * {@code palpate bench --sync}.
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

  /** Counts a change of a property. Writer, before the publication. */
  void countChange(Property property) {
    writes[property.index()]++;
  }

  /**
   * Takes the newest publication, if there is one. Reader.
   *
   * @return whether any property is dirty, now or because it was not applied before
   */
  public boolean take() {
    for (int tries = 0; tries < MAX_TRIES; tries++) {
      boolean copied = copyAll();
      if (copied) {
        keepCopy();
        break;
      }
      Thread.onSpinWait();
    }
    return anyPending();
  }

  /** Copies all values and returns whether they are of one publication. */
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

  /**
   * {@return the counters as of the last publication that was taken} Reader, or any thread after
   * both have ended.
   */
  public SyncCounters counters() {
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
