// A hand-built device that the unmodified hidapi finds, opens, reads and writes: umock_hid COMMAND
// [ARGUMENT ...] runs the command with a virtual /dev/hidraw0 behind umockdev and moves a hand at
// 1 kHz until the command ends. Its exit code is the command's; 125 where the device fails.
#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <umockdev.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "hand.h"
#include "palpate_device.h"

namespace {

constexpr const char* kNode = "/dev/hidraw0";
constexpr unsigned kUsb = 3;
constexpr int kFailed = 125;

palpate_device firmware;

palpate_capabilities capabilities() {
  palpate_capabilities can = {};
  can.max_force_mn = 6000;
  can.continuous_force_mn = 3000;
  can.max_stiffness_n_per_m = 1500;
  can.workspace_radius_tenth_mm = 600;
  can.report_interval_us = 1000;
  can.watchdog_ms = 20;
  can.buttons = 2;
  can.dof_in = 3;
  can.dof_out = 3;
  return can;
}

std::string descriptorHex() {
  std::string hex;
  char two[3];
  for (size_t i = 0; i < palpate_report_descriptor_bytes; i++) {
    std::snprintf(two, sizeof two, "%02X", palpate_report_descriptor[i]);
    hex += two;
  }
  return hex;
}

/** The device as udev and sysfs describe one on USB. */
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

/** What hidraw's ioctls say of the device. */
gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer) {
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
    const hidraw_devinfo info = {kUsb, 0x1209, 0x4A01};
    return answer(client, &info, sizeof info, 0);
  }
  if (_IOC_TYPE(request) == 'H' && _IOC_NR(request) == 0x07) {
    uint8_t report[PALPATE_CAPABILITIES_BYTES];
    palpate_device_feature(&firmware, report);
    return answer(client, report, sizeof report, sizeof report);
  }
  return FALSE;
}

pid_t run(char** command, int master) {
  const pid_t child = fork();
  if (child == 0) {
    close(master);  // else unplugging would never be seen
    execvp(command[0], command);
    std::perror(command[0]);
    _exit(127);
  }
  return child;
}

/** Takes what the host has sent; a pty is a stream, so reports are put together again. */
int receive(int master, uint32_t micros) {
  static uint8_t bytes[PALPATE_OUT_BYTES];
  static size_t have = 0;
  int count = 0;
  pollfd wait = {master, POLLIN, 0};
  while (poll(&wait, 1, 0) > 0 && (wait.revents & POLLIN) != 0) {
    const ssize_t got = read(master, bytes + have, sizeof bytes - have);
    if (got <= 0) {
      break;
    }
    have += static_cast<size_t>(got);
    if (have == sizeof bytes) {
      count += palpate_device_out(&firmware, bytes, have, micros);
      have = 0;
    }
  }
  return count;
}

/**
 * Sends a report where there is room. While nobody has the device open the pty fills up, and a
 * write that waits would wait for ever; where a part alone fitted, the rest goes before the next
 * report.
 */
void send(int master, const uint8_t (&report)[PALPATE_IN_BYTES]) {
  static uint8_t bytes[PALPATE_IN_BYTES];
  static size_t rest = 0;
  if (rest == 0) {
    std::memcpy(bytes, report, sizeof bytes);
    rest = sizeof bytes;
  }
  const ssize_t written = write(master, bytes + sizeof bytes - rest, rest);
  rest -= written > 0 ? static_cast<size_t>(written) : 0;
}

/** Moves the hand until the command ends; its status. */
int serve(int master, pid_t child) {
  Felt felt;
  palpate_pose pose = {};
  pose.calibrated = 1;
  pose.hand_present = 1;
  pose.quaternion[3] = 32767;
  palpate_motors motors = {};
  const long start = nowNanos();
  long openedMillis = -1;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const long millis = nextMillisecond(start);
    const auto micros = static_cast<uint32_t>(millis * 1000);
    const int reports = receive(master, micros);
    openedMillis = reports > 0 && openedMillis < 0 ? millis : openedMillis;
    moveHand(pose, openedMillis < 0 ? 0 : static_cast<double>(millis - openedMillis) / 1000);
    uint8_t report[PALPATE_IN_BYTES];
    palpate_device_in(&firmware, &pose, micros, report);
    send(master, report);
    palpate_device_motors(&firmware, micros, &motors);
    if (openedMillis >= 0) {
      felt.note(motors, reports);
    }
  }
  const auto micros = static_cast<uint32_t>((nowNanos() - start) / 1000);
  receive(master, micros);
  palpate_device_motors(&firmware, micros, &motors);
  felt.say("umock_hid", firmware, motors);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
}

int failed(GError* error) {
  std::fprintf(stderr, "umock_hid: %s\n", error->message);
  return kFailed;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "umock_hid: which command: umock_hid COMMAND [ARGUMENT ...]\n");
    return 2;
  }
  const palpate_capabilities can = capabilities();
  palpate_device_init(&firmware, &can);
  GError* error = nullptr;
  UMockdevTestbed* testbed = umockdev_testbed_new();
  if (!umockdev_testbed_add_from_string(testbed, description().c_str(), &error)) {
    return failed(error);
  }
  UMockdevIoctlBase* ioctls = umockdev_ioctl_base_new();
  g_signal_connect(ioctls, "handle-ioctl", G_CALLBACK(onIoctl), nullptr);
  if (!umockdev_testbed_attach_ioctl(testbed, kNode, ioctls, &error)) {
    return failed(error);
  }
  const int master = umockdev_testbed_get_dev_fd(testbed, kNode);
  fcntl(master, F_SETFL, fcntl(master, F_GETFL) | O_NONBLOCK);
  const int status = serve(master, run(arguments + 1, master));
  g_object_unref(ioctls);
  g_object_unref(testbed);
  return status;
}
