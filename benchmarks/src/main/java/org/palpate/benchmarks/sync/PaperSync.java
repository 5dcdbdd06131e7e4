package org.palpate.benchmarks.sync;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * The paper's accumulators. Every access is synchronized and adds a changed value to a list; the
 * synchronization applies the list under the same lock.
 *
 * <p>Source: Vlasov et al. 2013, section 5.2.
 */
final class PaperSync {
  /** Applies the properties to the scene. */
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

  /** A position that records its changes; guarded by the lock. */
  private final class Position {
    private final Vec3 value = new Vec3();

    void set(Vec3 newValue) {
      if (!value.sameBits(newValue)) {
        value.set(newValue);
        if (!changed.contains(this)) {
          changed.add(this);
        }
      }
    }
  }

  /** Publishes the properties of a frame; haptic thread. */
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

  /** Applies all changes while it holds the lock; synchronization thread, 30 Hz. */
  void synchronize(Applier applier) {
    synchronized (lock) {
      if (!changed.isEmpty()) {
        changed.clear();
        applier.apply(device.value, point.value, force.value, contact);
      }
    }
  }
}
