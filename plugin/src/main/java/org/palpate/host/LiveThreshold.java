package org.palpate.host;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.palpate.edit.SwapEdit;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Changes the threshold of a segment while it is touched. A thread of its own computes the new
 * voxels, and the edit queue swaps them in between two frames. If a solid then touches the
 * interaction point, the frame sets it free, as after any edit.
 *
 * <p>Any thread requests a threshold. Only the newest request counts if the thread falls behind.
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
   * A segment whose voxels a threshold selected.
   *
   * @param segment number of the segment
   * @param values the grey values
   * @param low the threshold at the start: the smallest value of the segment's voxels
   * @param high the largest value; infinite if there is no limit
   * @param contrast difference between bright and dark voxels; a step is a hundredth of it
   */
  public record Start(int segment, ScalarVolume values, double low, double high, double contrast) {}

  /** Receives new voxels after the haptic thread took them. Called by the threshold's thread. */
  interface Receiver {
    /**
     * Receives the voxels.
     *
     * @param grey the grey values from which the surface is made
     */
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

  /**
   * Adds the keys that lower and raise the threshold.
   *
   * @param refusal the reason why the threshold must not change, which the keys show; empty if it
   *     may change
   */
  void addKeys(WindowInput input, String refusal, SessionOverlay overlay) {
    input.onHeldKey('<', "lower threshold", () -> change(-1, refusal, overlay));
    input.onHeldKey('>', "higher threshold", () -> change(1, refusal, overlay));
  }

  private void change(int steps, String refusal, SessionOverlay overlay) {
    if (refusal.isEmpty()) {
      change(steps);
      overlay.invalidate();
    } else {
      overlay.hint(refusal);
    }
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

  private void offer(BooleanSupplier offer) {
    while (!closed && !offer.getAsBoolean()) {
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
