// A hand-built device in the HID core of this kernel. uhid_hid COMMAND [ARGUMENT ...] simulates it
// over /dev/uhid and moves a hand at 1 kHz until the command ends. Its exit code is that of the
// command, or 125 if the device fails. It needs root and the kernel's uhid, so run it in a virtual
// machine.
#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "virtual_device.h"

namespace {

constexpr const char* kNode = "/dev/uhid";
constexpr uint16_t kUsb = 3;
constexpr uint16_t kNotSupported = 95;
constexpr int kStartMillis = 10000;

void copyText(uint8_t* to, size_t bytes, const char* text) {
  std::memcpy(to, text, std::min(bytes - 1, std::strlen(text)));
}

class KernelDevice : public VirtualDevice {
 public:
  ~KernelDevice() override {
    if (uhid_ >= 0) {
      close(uhid_);  // the kernel removes the device
    }
  }

  /** Plugs it in and waits until the kernel has a driver for it. */
  bool plugIn() {
    uhid_ = open(kNode, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    uhid_event event = {};
    event.type = UHID_CREATE2;
    uhid_create2_req& made = event.u.create2;
    copyText(made.name, sizeof made.name, kName);
    copyText(made.phys, sizeof made.phys, "palpate/input0");
    copyText(made.uniq, sizeof made.uniq, kSerial);
    made.bus = kUsb;
    made.vendor = kVendor;
    made.product = kProduct;
    made.rd_size = static_cast<uint16_t>(palpate_report_descriptor_bytes);
    std::memcpy(made.rd_data, palpate_report_descriptor, palpate_report_descriptor_bytes);
    return uhid_ >= 0 && tell(event) && waitForStart();
  }

 private:
  bool tell(const uhid_event& event) {
    return write(uhid_, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
  }

  bool waitForStart() {
    pollfd wait = {uhid_, POLLIN, 0};
    uhid_event event = {};
    while (poll(&wait, 1, kStartMillis) > 0 && read(uhid_, &event, sizeof event) > 0) {
      if (event.type == UHID_START) {
        return true;
      }
    }
    return false;
  }

  int receive(uint32_t micros) override {
    int count = 0;
    uhid_event event = {};
    while (read(uhid_, &event, sizeof event) > 0) {
      if (event.type == UHID_OUTPUT) {
        count += palpate_device_out(&firmware_, event.u.output.data, event.u.output.size, micros);
      } else if (event.type == UHID_GET_REPORT) {
        answer(event.u.get_report);
      } else if (event.type == UHID_SET_REPORT) {
        refuse(event.u.set_report.id);
      }
    }
    return count;
  }

  void answer(const uhid_get_report_req& asked) {
    uhid_event event = {};
    event.type = UHID_GET_REPORT_REPLY;
    uhid_get_report_reply_req& reply = event.u.get_report_reply;
    reply.id = asked.id;
    if (asked.rtype == UHID_FEATURE_REPORT && asked.rnum == PALPATE_CAPABILITIES_ID) {
      uint8_t report[PALPATE_CAPABILITIES_BYTES];
      palpate_device_feature(&firmware_, report);
      std::memcpy(reply.data, report, sizeof report);
      reply.size = sizeof report;
    } else {
      reply.err = kNotSupported;
    }
    tell(event);
  }

  void refuse(uint32_t id) {
    uhid_event event = {};
    event.type = UHID_SET_REPORT_REPLY;
    event.u.set_report_reply.id = id;
    event.u.set_report_reply.err = kNotSupported;
    tell(event);
  }

  void send(const uint8_t (&report)[PALPATE_IN_BYTES]) override {
    uhid_event event = {};
    event.type = UHID_INPUT2;
    event.u.input2.size = sizeof report;
    std::memcpy(event.u.input2.data, report, sizeof report);
    tell(event);
  }

  int uhid_ = -1;
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "uhid_hid: which command: uhid_hid COMMAND [ARGUMENT ...]\n");
    return 2;
  }
  KernelDevice device;
  if (!device.plugIn()) {
    std::perror("uhid_hid: /dev/uhid");
    return VirtualDevice::kFailed;
  }
  return device.serve("uhid_hid", arguments + 1);
}
