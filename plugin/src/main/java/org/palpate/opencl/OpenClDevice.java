package org.palpate.opencl;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/**
 * An OpenCL device as a collision device. The first call that fails, or that takes longer than the
 * deadline, ends its work for good: the CPU then does the same work in the same frame.
 *
 * <p>A device that was given up is never freed. A call may still hang in it, and the driver may
 * still write to its memory.
 */
public final class OpenClDevice implements CollisionDevice {
  /**
   * The time within which a batch must be judged, ns. It is half of the 10 ms that a frame may take
   * in which the device fails, because the CPU then does the work afterwards.
   */
  static final long DEADLINE_NANOS = 5_000_000;

  /** The time within which the first batches must be judged, ns. Drivers compile during them. */
  static final long FIRST_DEADLINE_NANOS = 60_000_000_000L;

  /** Keeps the memory of devices that were given up, which the driver may still write to. */
  private static final List<ClDriver> GIVEN_UP = Collections.synchronizedList(new ArrayList<>());

  /**
   * When a batch is used.
   *
   * @param crossover the number of legs from which it is faster than the CPU
   * @param motionsAtOnce the number of motions that it judges in one launch
   */
  record Choice(long crossover, int motionsAtOnce) {}

  /** Finds out when a batch is faster than the CPU. */
  @FunctionalInterface
  interface Chooser {
    /**
     * Decides when to use a batch. It must be ready afterwards: whatever a driver does at the first
     * launch is done.
     *
     * @param batch not used before
     * @param firstNanos the time within which its first launch must end
     */
    Choice choose(OpenClLegs batch, PointSet points, long firstNanos);
  }

  private enum State {
    IDLE,
    BUSY,
    CLOSED,
    GIVEN_UP
  }

  private final ClDriver driver;
  private final long deadlineNanos;
  private final Chooser chooser;
  private final AtomicReference<State> state = new AtomicReference<>(State.IDLE);
  private volatile String failure;
  private long batches;

  OpenClDevice(ClDriver driver, long deadlineNanos, Chooser chooser) {
    this.driver = driver;
    this.deadlineNanos = deadlineNanos;
    this.chooser = chooser;
  }

  /**
   * Opens a device and compares its verdicts with those of the CPU.
   *
   * @param part a part of the device's name in any case; empty for the first that can be used, a
   *     GPU if there is one
   * @throws OpenClException if there is no such device, or it cannot be used
   */
  public static OpenClDevice open(String part) throws OpenClException {
    return open(() -> OpenClCatalog.open(part), DEADLINE_NANOS, new LaunchCost(DEADLINE_NANOS));
  }

  static OpenClDevice open(Supplier<ClDriver> drivers, long deadlineNanos, Chooser chooser)
      throws OpenClException {
    OpenClDevice device;
    try {
      device = new OpenClDevice(drivers.get(), deadlineNanos, chooser);
    } catch (RuntimeException | LinkageError e) {
      throw new OpenClException(reason(e), e instanceof OpenClCatalog.WrongChoiceException, e);
    }
    return device
        .attempt(() -> compared(device))
        .orElseThrow(() -> new OpenClException(device.failure().orElseThrow(), false, null));
  }

  private static OpenClDevice compared(OpenClDevice device) {
    HostileSelfTest.requireExact(device, FIRST_DEADLINE_NANOS);
    return device;
  }

  @Override
  public DeviceVoxels keep(BitCube voxels) {
    return this.<DeviceVoxels>attempt(() -> new OpenClVoxels(this, driver, voxels))
        .orElseGet(() -> CPU.keep(voxels));
  }

  /** Returns a batch that no chooser has seen. */
  OpenClLegs newBatch(BitCube voxels, PointSet points) {
    return new OpenClLegs(this, driver, new OpenClVoxels(this, driver, voxels), points);
  }

  /** Decides when to use a batch, and returns the batch. */
  OpenClLegs chosen(OpenClLegs batch, PointSet points) {
    batch.setChoice(chooser.choose(batch, points, FIRST_DEADLINE_NANOS));
    return batch;
  }

  /** Runs an action that uses the driver. If it fails, gives the device up and returns empty. */
  <T> Optional<T> attempt(Supplier<T> action) {
    if (!begin()) {
      return Optional.empty();
    }
    try {
      return Optional.of(action.get());
    } catch (RuntimeException | LinkageError | OutOfMemoryError e) {
      giveUp(e);
      return Optional.empty();
    } finally {
      end();
    }
  }

  long deadlineNanos() {
    return deadlineNanos;
  }

  /** Reserves the device for some calls; false if it was closed or given up. */
  boolean begin() {
    return state.compareAndSet(State.IDLE, State.BUSY);
  }

  /** Releases the device after {@link #begin}, unless it was given up meanwhile. */
  void end() {
    state.compareAndSet(State.BUSY, State.IDLE);
  }

  void giveUp(Throwable cause) {
    GIVEN_UP.add(driver);
    failure = reason(cause);
    state.set(State.GIVEN_UP);
  }

  /** Returns the first line of the message of a failure. */
  static String reason(Throwable cause) {
    String text = cause.getMessage() == null ? cause.toString() : cause.getMessage();
    return text.strip().lines().findFirst().orElse("");
  }

  void countBatch() {
    batches++;
  }

  @Override
  public long batches() {
    return batches;
  }

  @Override
  public String name() {
    return driver.name();
  }

  @Override
  public Optional<String> failure() {
    return Optional.ofNullable(failure);
  }

  @Override
  public void close() {
    if (!state.compareAndSet(State.IDLE, State.CLOSED)) {
      return;
    }
    try {
      driver.release();
    } catch (RuntimeException | LinkageError e) {
      failure = reason(e);
    }
  }
}
