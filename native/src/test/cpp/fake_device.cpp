#include "fake_device.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

palpate_capabilities FakeDevice::capabilities() {
  palpate_capabilities can = {};
  can.max_force_mn = 6000;
  can.continuous_force_mn = 5000;
  can.max_stiffness_n_per_m = 1500;
  can.max_torque_tenth_mnm = 0;
  can.workspace_radius_tenth_mm = 600;
  can.report_interval_us = 1000;
  can.watchdog_ms = 20;
  can.buttons = 2;
  can.dof_in = 6;
  can.dof_out = 3;
  return can;
}

FakeDevice::FakeDevice(const std::string& folder, const std::string& serial, const char* kind,
                       const palpate_capabilities& can)
    : path_(folder + "/" + kind + "-" + serial + ".sock"),
      listener_(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)) {
  palpate_device_init(&firmware, &can);
  palpate_device_feature(&firmware, feature_);
  pose.calibrated = 1;
  pose.hand_present = 1;
  pose.quaternion[3] = 32767;
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
  unlink(path_.c_str());
  bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
  listen(listener_, 4);
  acceptor_ = std::thread([this] { acceptAll(); });
}

FakeDevice::~FakeDevice() {
  ending_ = true;
  acceptor_.join();
  unplug();
  close(listener_);
  unlink(path_.c_str());
}

void FakeDevice::acceptAll() {
  while (!ending_) {
    pollfd wait = {listener_, POLLIN, 0};
    if (poll(&wait, 1, 5) > 0) {
      const int connection = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (connection >= 0) {
        answer(connection);
      }
    }
  }
}

void FakeDevice::answer(int connection) {
  char purpose = 0;
  recv(connection, &purpose, 1, 0);
  if (purpose == 'D') {
    const int unused = incoming_.exchange(connection);
    if (unused >= 0) {
      close(unused);
    }
    return;
  }
  send(connection, feature_, sizeof feature_, MSG_NOSIGNAL);
  close(connection);
}

/**
 * Returns the socket of the host. A new connection replaces the old one, which only this thread
 * closes.
 */
int FakeDevice::socketNow() {
  const int next = incoming_.exchange(-1);
  if (next >= 0) {
    if (data_ >= 0) {
      close(data_);
    }
    data_ = next;
  }
  return data_;
}

std::vector<uint8_t> FakeDevice::nextReport(uint32_t nowMicros) {
  std::vector<uint8_t> report(PALPATE_IN_BYTES);
  palpate_device_in(&firmware, &pose, nowMicros, report.data());
  return report;
}

bool FakeDevice::step(uint32_t nowMicros) { return sendRaw(nextReport(nowMicros)); }

bool FakeDevice::sendRaw(const std::vector<uint8_t>& bytes) {
  const int socket = socketNow();
  if (socket < 0) {
    return false;
  }
  const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  withoutRoom_ += sent < 0 ? 1 : 0;
  return sent > 0;
}

int FakeDevice::receive(uint32_t nowMicros) {
  int count = 0;
  uint8_t report[64];
  for (const int socket = socketNow(); socket >= 0;) {
    const ssize_t length = recv(socket, report, sizeof report, MSG_DONTWAIT);
    if (length <= 0) {
      break;
    }
    lastOut.assign(report, report + length);
    if (heard && length == PALPATE_OUT_BYTES) {
      heard(report);
    }
    count += palpate_device_out(&firmware, report, static_cast<size_t>(length), nowMicros);
  }
  return count;
}

palpate_motors FakeDevice::motors(uint32_t nowMicros) {
  palpate_motors now;
  palpate_device_motors(&firmware, nowMicros, &now);
  return now;
}

void FakeDevice::unplug() {
  if (socketNow() >= 0) {
    close(data_);
    data_ = -1;
  }
}
