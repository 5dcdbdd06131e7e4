package org.palpate.host;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.palpate.edit.SwapEdit;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.scene.surface.GreyRange;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Changes the threshold of a segment while it is touched: makes its voxels anew aside, and swaps
 * them between two frames. If a solid then touches the interaction point, the frame sets it free.
 *
 * <p>Any thread asks for a threshold. A thread of its own makes the voxels; if it falls behind, it
 * leaves thresholds out.
 */
public final class LiveThreshold implements AutoCloseable {
  private static final long WAIT_NANOS = 1_000_000;
  private static final double STEPS_PER_CONTRAST = 100;

  private final ContactScene scene;
  private final Start start;
  private final Receiver receiver;
  private final double stepSize;
  private final AtomicReference<Double> requested = new AtomicReference<>();
  private final Thread thread = new Thread(this::work, "palpate-threshold");
  private volatile double threshold;
  private volatile boolean closed;

  /**
   * A segment that a threshold made.
   *
   * @param segment its number
   * @param values the grey values
   * @param low the least value of its voxels at first
   * @param high the largest value, infinite if there is no limit
   * @param contrast difference between bright and dark voxels; a key changes a hundredth of it
   */
  public record Start(int segment, ScalarVolume values, double low, double high, double contrast) {}

  /** Receives new voxels once the haptic thread collides with them. On the thread of its own. */
  interface Receiver {
    void replaced(int segment, BitCube bits, Optional<GreyRange> grey);
  }

  LiveThreshold(ContactScene scene, Start start, Receiver receiver) {
    this.scene = scene;
    this.start = start;
    this.receiver = receiver;
    threshold = start.low;
    double step = start.contrast / STEPS_PER_CONTRAST;
    stepSize = start.values.storage() == ScalarVolume.Storage.FLOAT32 ? step : Math.ceil(step);
    thread.setDaemon(true);
  }

  /** Starts the thread. */
  void start() {
    thread.start();
  }

  /** Changes the threshold by a number of steps. Any thread. */
  synchronized void change(int steps) {
    double next = Math.min(start.high, threshold + steps * stepSize);
    threshold = next;
    requested.set(next);
    LockSupport.unpark(thread);
  }

  /** Returns the line of the overlay. */
  String line() {
    return scene.volume().segments().get(start.segment).name()
        + " from "
        + NumberText.display(threshold);
  }

  private void work() {
    while (!closed) {
      Double next = requested.getAndSet(null);
      if (next == null) {
        LockSupport.park(this);
      } else {
        apply(next);
      }
    }
  }

  private void apply(double low) {
    BitCube bits = voxels(low);
    SwapEdit swap = new SwapEdit(start.segment, bits);
    offer(() -> scene.edits().offer(swap));
    if (scene.grey().isPresent()) {
      GreyIsosurface surface = GreyIsosurface.ofThreshold(start.values, low);
      offer(() -> scene.offerGrey(surface));
    }
    while (!closed && !swap.isDone()) {
      LockSupport.parkNanos(this, WAIT_NANOS);
    }
    if (!closed) {
      GreyRange range = new GreyRange(start.values, low, start.high);
      receiver.replaced(start.segment, bits, Optional.of(range));
    }
  }

  private interface Offer {
    boolean isTaken();
  }

  private void offer(Offer offer) {
    while (!closed && !offer.isTaken()) {
      LockSupport.parkNanos(this, WAIT_NANOS);
    }
  }

  private BitCube voxels(double low) {
    VoxelGrid grid = start.values.grid();
    BitCube bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int k = 0; k < grid.sizeZ() && !closed; k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          double value = start.values.value(i, j, k);
          if (value >= low && value <= start.high) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  /** Ends the thread without waiting for it. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
  }
}
