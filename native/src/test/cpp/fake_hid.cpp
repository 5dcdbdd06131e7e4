// A fake hand-built device as a process: fake_hid FOLDER SERIAL [SECONDS]. The substitute of hidapi
// finds it by PALPATE_FAKE_HID=FOLDER. It moves a hand at 1 kHz.
#include <csignal>
#include <cstdlib>

#include "fake_device.h"
#include "hand.h"

namespace {

volatile std::sig_atomic_t ending = 0;

void end(int) { ending = 1; }

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    return 2;
  }
  const double seconds = count > 3 ? std::atof(arguments[3]) : 1e9;
  std::signal(SIGTERM, end);
  FakeDevice device(arguments[1], arguments[2]);
  Felt felt;
  const long start = nowNanos();
  long openedMillis = -1;
  for (long millis = 0; ending == 0 && static_cast<double>(millis) < seconds * 1000;) {
    millis = nextMillisecond(start);
    const auto micros = static_cast<uint32_t>(millis * 1000);
    openedMillis = device.isOpen() && openedMillis < 0 ? millis : openedMillis;
    moveHand(device.pose, openedMillis < 0 ? 0 : static_cast<double>(millis - openedMillis) / 1000);
    const int reports = device.receive(micros);
    device.step(micros);
    felt.note(device.motors(micros), reports);
  }
  const auto micros = static_cast<uint32_t>((nowNanos() - start) / 1000);
  device.receive(micros);
  felt.say("fake_hid", device.firmware, device.motors(micros));
  return 0;
}
