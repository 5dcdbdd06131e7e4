package org.palpate.benchmarks.stress;

import java.util.SplittableRandom;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/**
 * A device in grid coordinates with a hostile hand and a faulty connection: NaN, infinities,
 * repeated samples, times that stop and go back, writes that do not arrive. Never disconnects.
 */
final class FaultyDevice implements HapticDevice {
  static final double MAX_FORCE_NEWTON = 8;

  private static final DeviceSpecification SPECIFICATION =
      new DeviceSpecification("hostile", "", MAX_FORCE_NEWTON, 1, 100, 1_000_000);

  private final SplittableRandom random;
  private final HostileHand hand;
  private final Vec3 position = new Vec3();
  private final Vec3 lastForce = new Vec3();
  private InteractionPoint point = new InteractionPoint();
  private long nanos;
  private int unreached;

  FaultyDevice(SplittableRandom random, HostileHand hand, Vec3 start) {
    this.random = random;
    this.hand = hand;
    position.set(start);
  }

  /** Sets the interaction point that the hand aims at. */
  void aimAt(InteractionPoint aim) {
    point = aim;
  }

  /** Returns the last written force, whether or not it arrived. */
  Vec3 lastForce() {
    return lastForce;
  }

  @Override
  public DeviceSpecification specification() {
    return SPECIFICATION;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    int fault = random.nextInt(40);
    if (fault == 0) {
      return ReadStatus.REPEATED;
    }
    nanos += fault == 1 ? 0 : fault == 2 ? -random.nextLong(5_000_000) : 1_000_000;
    hand.next(point.position, position);
    state.positionMm.set(position);
    state.timeNanos = nanos;
    if (fault == 3) {
      double[] none = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
      state.positionMm.set(random.nextInt(3), none[random.nextInt(none.length)]);
    }
    return ReadStatus.FRESH;
  }

  /** Fails sometimes, and rarely twice in a row. */
  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    lastForce.set(forceNewton);
    boolean reached = random.nextInt(50) != 0 || unreached > 2;
    unreached = reached ? 0 : unreached + 1;
    return reached;
  }

  @Override
  public void close() {}
}
