#include "substitutes/panel.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace substitutes {
namespace {

constexpr int kTimeOutMicros = 30000;

Panel* mapped() {
  const char* file = std::getenv("PALPATE_PANEL");
  const int descriptor = file != nullptr ? open(file, O_RDWR) : -1;
  void* bytes = MAP_FAILED;
  if (descriptor >= 0) {
    bytes = mmap(nullptr, sizeof(Panel), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    close(descriptor);
  }
  return bytes != MAP_FAILED ? static_cast<Panel*>(bytes)
                             : static_cast<Panel*>(std::calloc(1, sizeof(Panel)));
}

void note(Panel& p, const char* name) {
  static std::mutex naming;
  const int known = p.calledCount.load();
  for (int i = 0; i < known; i++) {
    if (std::strcmp(p.called[i].name, name) == 0) {
      p.called[i].times++;
      return;
    }
  }
  const std::lock_guard<std::mutex> guard(naming);
  const int next = p.calledCount.load();
  std::strncpy(p.called[next].name, name, sizeof p.called[next].name - 1);
  p.called[next].times = 1;
  p.calledCount = next + 1;
}

}  // namespace

Panel& panel() {
  static Panel* one = mapped();
  return *one;
}

Call::Call(const char* name, bool oneThreadAtATime) : counted_(oneThreadAtATime) {
  Panel& p = panel();
  note(p, name);
  if (counted_ && p.inside.fetch_add(1) > 0) {
    p.overlaps++;
  }
  fails_ = p.unplugged.load() != 0;
  int32_t fault = p.fault.load();
  if (fault == kNone || std::strcmp(p.faultCall, name) != 0) {
    return;
  }
  const bool once = fault == kErrorOnce || fault == kTimeOut || fault == kHang;
  if (once && !p.fault.compare_exchange_strong(fault, kNone)) {
    return;
  }
  p.struck++;
  if (fault == kTimeOut) {
    usleep(kTimeOutMicros);
  }
  while (fault == kHang && p.released.load() == 0) {
    usleep(1000);
  }
  if (fault == kUnplugged) {
    p.unplugged = 1;
  }
  givesNaN_ = fault == kNotANumber;
  fails_ = fails_ || (fault != kNotANumber && fault != kHang);
}

Call::~Call() {
  if (counted_) {
    panel().inside--;
  }
}

void noteForce(const double* force, const double* torque) {
  Panel& p = panel();
  for (int axis = 0; axis < 3; axis++) {
    p.force[axis] = force[axis];
    p.torque[axis] = torque != nullptr ? torque[axis] : 0;
    const double size = std::fabs(force[axis]);
    if (size > p.largest.load() || std::isnan(size)) {
      p.largest = size;
    }
  }
  p.forces++;
}

}  // namespace substitutes
