#include "bench.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>

#include "check.h"
#include "device/clock.h"

namespace bench {
namespace {

substitutes::Panel* mapPanel() {
  const std::string file = fakeFolder() + "/panel";
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0600);
  if (ftruncate(descriptor, sizeof(substitutes::Panel)) != 0) {
    std::abort();
  }
  void* bytes =
      mmap(nullptr, sizeof(substitutes::Panel), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  setenv("PALPATE_PANEL", file.c_str(), 1);
  return static_cast<substitutes::Panel*>(bytes);
}

}  // namespace

const std::string& fakeFolder() {
  static const std::string* folder = [] {
    char pattern[] = "/tmp/palpate-test-XXXXXX";
    auto* made = new std::string(mkdtemp(pattern));
    setenv("PALPATE_FAKE_HID", made->c_str(), 1);
    std::atexit([] {
      std::error_code ignored;  // files that remain do not fail a test
      std::filesystem::remove_all(fakeFolder(), ignored);
    });
    return made;
  }();
  return *folder;
}

substitutes::Panel& freshPanel() {
  static substitutes::Panel* mapped = mapPanel();
  std::memset(static_cast<void*>(mapped), 0, sizeof *mapped);
  mapped->tickMicros = 100;
  return *mapped;
}

void advanceMillis(int millis) {
  if (palpate::heldNanos == 0) {
    palpate::heldNanos = palpate::kNanosPerSecond;
  }
  palpate::heldNanos += millis * palpate::kNanosPerMilli;
}

int64_t open(const std::string& backend, const std::string& id) {
  std::string why;
  const int64_t handle = palpate::Session::open(*palpate::backendNamed(backend), id,
                                                2 * palpate::kNanosPerSecond, why);
  CHECK_THAT(handle != 0, why);
  return handle;
}

palpate::ReadStatus readFresh(int64_t handle) {
  for (int i = 0; i < 2000; i++) {
    const palpate::ReadStatus status = palpate::Session::read(handle);
    if (status != palpate::ReadStatus::kRepeated) {
      return status;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  return palpate::ReadStatus::kRepeated;
}

bool push(int64_t handle, double x, double y, double z) {
  palpate::Frame* frame = palpate::Session::frame(handle);
  if (frame == nullptr) {
    return false;
  }
  double* force = frame->wrench.forceNewton;
  force[0] = x;
  force[1] = y;
  force[2] = z;
  return palpate::Session::write(handle);
}

void holdStill(int64_t handle) {
  for (int i = 0; i < 200; i++) {
    advanceMillis(5);
    readFresh(handle);
    push(handle, 0, 0, 0);
  }
}

}  // namespace bench
