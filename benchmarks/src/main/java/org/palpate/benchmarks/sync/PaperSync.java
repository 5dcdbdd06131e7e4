package org.palpate.benchmarks.sync;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * Accumulators as the paper has them: every access is synchronized, a changed one is put on a list,
 * the synchronization goes through the list and applies it, all under one lock.
 *
 * <p>Source: Vlasov et al. 2013, section 5.2.
 */
final class PaperSync {
  /** Takes a property that is to be applied. */
  @FunctionalInterface
  interface Applier {
    void apply(Vec3 device, Vec3 point, Vec3 force, boolean contact);
  }

  private final Object lock = new Object();
  private final Position device = new Position();
  private final Position point = new Position();
  private final Position force = new Position();
  private final List<Object> changed = new ArrayList<>();
  private boolean contact;

  /** A position that notes its changes; guarded by the lock. */
  private final class Position {
    private final Vec3 value = new Vec3();

    void set(Vec3 wanted) {
      if (!value.sameBits(wanted)) {
        value.set(wanted);
        if (!changed.contains(this)) {
          changed.add(this);
        }
      }
    }
  }

  /** The haptic thread's part. */
  void publish(Vec3 deviceGrid, Vec3 pointGrid, Vec3 forceNewton, boolean touching, long frame) {
    synchronized (lock) {
      device.set(deviceGrid);
    }
    synchronized (lock) {
      point.set(pointGrid);
    }
    synchronized (lock) {
      force.set(forceNewton);
    }
    synchronized (lock) {
      contact = touching;
    }
  }

  /** The synchronization thread's part, at 30 Hz: the lock is held while the scene is changed. */
  void synchronize(Applier applier) {
    synchronized (lock) {
      if (!changed.isEmpty()) {
        changed.clear();
        applier.apply(device.value, point.value, force.value, contact);
      }
    }
  }
}
