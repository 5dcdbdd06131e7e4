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

  /** Makes a device that puts the samples of {@code device} into {@code recorder}. */
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
