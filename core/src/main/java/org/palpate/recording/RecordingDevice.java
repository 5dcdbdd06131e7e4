package org.palpate.recording;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;

/**
 * Records every new sample of a device and otherwise passes all calls on to it.
 *
 * <p>It wraps the device that delivers world millimetres, before {@code host} turns them into grid
 * coordinates. The recording can therefore be replayed in the world.
 */
public final class RecordingDevice extends DeviceDecorator {
  private final SampleRecorder recorder;

  /**
   * Makes a device that records the samples of another one.
   *
   * @param device delivers the samples; it is closed with this device
   * @param recorder receives each new sample
   */
  public RecordingDevice(HapticDevice device, SampleRecorder recorder) {
    super(device);
    this.recorder = recorder;
  }

  @Override
  public ReadStatus read(DeviceState state) {
    ReadStatus status = device.read(state);
    if (status == ReadStatus.FRESH) {
      recorder.offer(state);
    }
    return status;
  }
}
