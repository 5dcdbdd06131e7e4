package org.palpate.device;

import org.palpate.geometry.Vec3;

/** Is the device behind it, but for what a subclass does otherwise. Threads as that device's. */
public abstract class DeviceDecorator implements HapticDevice {
  /** The device behind this one. */
  protected final HapticDevice device;

  /** Stands before {@code device}, and closes it when it is closed. */
  protected DeviceDecorator(HapticDevice device) {
    this.device = device;
  }

  @Override
  public DeviceSpecification specification() {
    return device.specification();
  }

  @Override
  public ReadStatus read(DeviceState state) {
    return device.read(state);
  }

  @Override
  public boolean write(Vec3 forceNewton) {
    return device.write(forceNewton);
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
