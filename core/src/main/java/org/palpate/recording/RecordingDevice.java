package org.palpate.recording;

import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;

/**
 * Records every new sample of a device and is otherwise that device. Wraps the device that delivers
 * world millimetres, before {@code host} turns them into grid coordinates, so that the recording
 * can be replayed in the world.
 */
public final class RecordingDevice extends DeviceDecorator {
  private final SampleRecorder recorder;

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
