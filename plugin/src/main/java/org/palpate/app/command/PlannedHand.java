package org.palpate.app.command;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.GuidedHand;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

/**
 * A simulated hand that is planned in a thread of its own, while the session is built and warms up.
 * It is ready when the plan is, so that the first frame of the session waits for the plan.
 *
 * <p>Threads are those of {@link HapticDevice}.
 */
final class PlannedHand implements HapticDevice {
  private final DeviceSpecification specification;
  private final CompletableFuture<GuidedHand> plan = new CompletableFuture<>();
  private final Thread planner;

  /** The hand once it is planned, else null. Haptic thread. */
  private GuidedHand hand;

  private volatile boolean closed;

  /**
   * Begins to plan.
   *
   * @param radiusMm radius of the ball that the hand reaches
   * @param newHand makes the plan and the hand; runs once, in the thread, which {@link #close}
   *     interrupts
   */
  PlannedHand(double radiusMm, Supplier<GuidedHand> newHand) {
    specification = GuidedHand.specification(radiusMm);
    planner = new Thread(() -> plan(newHand), "palpate-plan");
    planner.setDaemon(true);
    planner.start();
  }

  /** Hands the hand over, or whatever kept it from being made. */
  private void plan(Supplier<GuidedHand> newHand) {
    try {
      plan.complete(newHand.get());
    } catch (Throwable thrown) {
      plan.completeExceptionally(thrown);
    }
  }

  @Override
  public DeviceSpecification specification() {
    return specification;
  }

  /**
   * Returns whether the plan is made. A closed hand is ready too, because nothing more will come.
   *
   * @throws IllegalStateException if it failed; an error of the JVM is thrown as it is
   */
  @Override
  public boolean isReady() {
    takeOver();
    return closed || hand != null;
  }

  /**
   * Takes the hand over once it is planned. Closing cancels the plan, so that a plan which is done
   * has no hand if the device has been closed.
   */
  private void takeOver() {
    if (hand == null && plan.isDone() && !closed) {
      hand = planned();
    }
  }

  private GuidedHand planned() {
    try {
      return plan.join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw new IllegalStateException("the plan of the simulated hand failed", e.getCause());
    }
  }

  @Override
  public ReadStatus read(DeviceState state) {
    takeOver();
    if (closed) {
      return ReadStatus.DISCONNECTED;
    }
    return hand != null ? hand.read(state) : ReadStatus.REPEATED;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return !closed;
  }

  @Override
  public void close() {
    closed = true;
    planner.interrupt();
  }
}
