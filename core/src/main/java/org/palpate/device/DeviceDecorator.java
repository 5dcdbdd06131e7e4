package org.palpate.device;

import org.palpate.geometry.Vec3;

/**
 * Delegates every call to the device behind it; a subclass changes what it needs to. Threads are
 * those of that device.
 */
public abstract class DeviceDecorator implements HapticDevice {
  /** The device behind this one. */
  protected final HapticDevice device;

  /**
   * Makes a decorator of another device, which it closes when it is closed itself.
   *
   * @param device receives every call that the subclass does not change
   */
  protected DeviceDecorator(HapticDevice device) {
    this.device = device;
  }

  @Override
  public DeviceSpecification specification() {
    return device.specification();
  }

  @Override
  public boolean isReady() {
    return device.isReady();
  }

  @Override
  public ReadStatus read(DeviceState state) {
    return device.read(state);
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    return device.write(forceNewton, torqueNewtonMm);
  }

  @Override
  public String ending() {
    return device.ending();
  }

  @Override
  public void close() {
    device.close();
  }
}
