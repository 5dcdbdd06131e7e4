// A hand-built device that the unmodified hidapi finds, opens, reads and writes. umock_hid COMMAND
// [ARGUMENT ...] runs the command with a virtual /dev/hidraw0 of umockdev, and moves a hand at 1
// kHz until the command ends. Its exit code is that of the command, or 125 if the device fails.
#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <umockdev.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "virtual_device.h"

namespace {

constexpr const char* kNode = "/dev/hidraw0";
constexpr unsigned kUsb = 3;

std::string descriptorHex() {
  std::string hex;
  char two[3];
  for (size_t i = 0; i < palpate_report_descriptor_bytes; i++) {
    std::snprintf(two, sizeof two, "%02X", palpate_report_descriptor[i]);
    hex += two;
  }
  return hex;
}

/** Returns the description that udev and sysfs have of such a device on USB. */
std::string description() {
  const std::string usb = "/devices/pci0000:00/0000:00:14.0/usb1/1-2";
  const std::string interface = usb + "/1-2:1.0";
  const std::string hid = interface + "/0003:1209:4A01.0001";
  return "P: " + hid +
         "/hidraw/hidraw0\nN: hidraw0\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=240\nE: MINOR=0\n"
         "E: SUBSYSTEM=hidraw\nA: dev=240:0\\n\nL: device=../../../0003:1209:4A01.0001\n\n"
         "P: " +
         hid +
         "\nE: DRIVER=hid-generic\nE: HID_ID=0003:00001209:00004A01\nE: HID_NAME=Virtual "
         "hand-built "
         "device\nE: HID_PHYS=usb-0000:00:14.0-2/input0\nE: HID_UNIQ=SN0001\n"
         "E: MODALIAS=hid:b0003g0001v00001209p00004A01\nE: SUBSYSTEM=hid\nH: report_descriptor=" +
         descriptorHex() + "\n\nP: " + interface +
         "\nE: DEVTYPE=usb_interface\nE: DRIVER=usbhid\nE: PRODUCT=1209/4a01/100\nE: TYPE=0/0/0\n"
         "E: INTERFACE=3/0/0\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\nA: "
         "bInterfaceClass=03\\n\n\nP: " +
         usb +
         "\nN: bus/usb/001/002\nE: DEVNAME=/dev/bus/usb/001/002\nE: DEVTYPE=usb_device\nE: "
         "DRIVER=usb\nE: PRODUCT=1209/4a01/100\nE: BUSNUM=001\nE: DEVNUM=002\nE: MAJOR=189\nE: "
         "MINOR=1\nE: SUBSYSTEM=usb\nA: idVendor=1209\\n\nA: idProduct=4a01\\n\nA: "
         "bcdDevice=0100\\n\nA: manufacturer=Palpate\\n\nA: product=Virtual hand-built device\\n\n"
         "A: serial=SN0001\\n\n\n";
}

bool answer(UMockdevIoctlClient* client, const void* bytes, size_t length, long result) {
  UMockdevIoctlData* pointer = umockdev_ioctl_client_get_arg(client);
  UMockdevIoctlData* data = umockdev_ioctl_data_resolve(pointer, 0, length, nullptr);
  if (data == nullptr) {
    return false;
  }
  auto* copy = static_cast<guint8*>(const_cast<void*>(bytes));
  umockdev_ioctl_data_update(data, 0, copy, static_cast<gint>(length));
  umockdev_ioctl_data_unref(data);
  umockdev_ioctl_client_complete(client, result, 0);
  return true;
}

/** Answers hidraw's ioctls about the device. */
gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer firmware) {
  const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
  if (request == HIDIOCGRDESCSIZE) {
    const int size = static_cast<int>(palpate_report_descriptor_bytes);
    return answer(client, &size, sizeof size, 0);
  }
  if (request == HIDIOCGRDESC) {
    hidraw_report_descriptor descriptor = {};
    descriptor.size = static_cast<unsigned>(palpate_report_descriptor_bytes);
    std::memcpy(descriptor.value, palpate_report_descriptor, descriptor.size);
    return answer(client, &descriptor, sizeof descriptor, 0);
  }
  if (request == HIDIOCGRAWINFO) {
    const hidraw_devinfo info = {kUsb, VirtualDevice::kVendor, VirtualDevice::kProduct};
    return answer(client, &info, sizeof info, 0);
  }
  if (_IOC_TYPE(request) == 'H' && _IOC_NR(request) == 0x07) {
    uint8_t report[PALPATE_CAPABILITIES_BYTES];
    palpate_device_feature(static_cast<palpate_device*>(firmware), report);
    return answer(client, report, sizeof report, sizeof report);
  }
  return FALSE;
}

/** The device's end of the pty behind the node. */
class MockedDevice : public VirtualDevice {
 public:
  palpate_device* firmware() { return &firmware_; }

  void connect(int master) {
    master_ = master;
    peer_ = ioctl(master, TIOCGPTPEER, O_RDWR | O_NOCTTY | O_CLOEXEC);
    fcntl(master, F_SETFL, fcntl(master, F_GETFL) | O_NONBLOCK);
    fcntl(master, F_SETFD, FD_CLOEXEC);  // otherwise unplugging is never noticed
  }

 private:
  /** Reassembles reports, because a pty is a stream. */
  int receive(uint32_t micros) override {
    int count = 0;
    pollfd wait = {master_, POLLIN, 0};
    while (poll(&wait, 1, 0) > 0 && (wait.revents & POLLIN) != 0) {
      const ssize_t got = read(master_, in_ + have_, sizeof in_ - have_);
      if (got <= 0) {
        break;
      }
      have_ += static_cast<size_t>(got);
      if (have_ == sizeof in_) {
        count += palpate_device_out(&firmware_, in_, have_, micros);
        have_ = 0;
        heard_ = true;
      }
    }
    return count;
  }

  /**
   * Sends no report before the host has sent one. Later it queues as many reports as hidraw does
   * for a host that does not read, and drops the others. A full pty would accept only a part of a
   * report, and reports read after that would be cut.
   */
  void send(const uint8_t (&report)[PALPATE_IN_BYTES]) override {
    if (!heard_) {
      tcflush(peer_, TCIFLUSH);
    }
    int unread = 0;
    if (ioctl(peer_, FIONREAD, &unread) != 0 || unread < kReports * PALPATE_IN_BYTES) {
      (void)!write(master_, report, sizeof report);
    }
  }

  static constexpr int kReports = 64;

  int master_ = -1;
  int peer_ = -1;  // the host's end, to see how much waits there
  uint8_t in_[PALPATE_OUT_BYTES] = {};
  size_t have_ = 0;
  bool heard_ = false;
};

int failed(GError* error) {
  std::fprintf(stderr, "umock_hid: %s\n", error->message);
  return VirtualDevice::kFailed;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "umock_hid: which command: umock_hid COMMAND [ARGUMENT ...]\n");
    return 2;
  }
  MockedDevice device;
  GError* error = nullptr;
  UMockdevTestbed* testbed = umockdev_testbed_new();
  if (!umockdev_testbed_add_from_string(testbed, description().c_str(), &error)) {
    return failed(error);
  }
  UMockdevIoctlBase* ioctls = umockdev_ioctl_base_new();
  g_signal_connect(ioctls, "handle-ioctl", G_CALLBACK(onIoctl), device.firmware());
  if (!umockdev_testbed_attach_ioctl(testbed, kNode, ioctls, &error)) {
    return failed(error);
  }
  device.connect(umockdev_testbed_get_dev_fd(testbed, kNode));
  const int status = device.serve("umock_hid", arguments + 1);
  g_object_unref(ioctls);
  g_object_unref(testbed);
  return status;
}
