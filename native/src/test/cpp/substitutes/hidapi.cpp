// A substitute for hidapi: its C interface over AF_UNIX SOCK_SEQPACKET, which keeps reports apart.
// Each socket in the folder PALPATE_FAKE_HID is a device. The file's name is
// VENDOR-PRODUCT-PAGE-USAGE-SERIAL.sock, with numbers in hexadecimal. If PALPATE_NULL_HID is set,
// there is one more device, which measures the cost of calls: every other read is a report, and
// every write is accepted.
#include <dirent.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <string>

#include "palpate_device.h"
#include "substitutes/panel.h"

using substitutes::Call;

struct hid_device_info {
  char* path;
  unsigned short vendor_id;
  unsigned short product_id;
  wchar_t* serial_number;
  unsigned short release_number;
  wchar_t* manufacturer_string;
  wchar_t* product_string;
  unsigned short usage_page;
  unsigned short usage;
  int interface_number;
  hid_device_info* next;
  int bus_type;
};

struct hid_device {
  int socket;  // kNothing for the device of PALPATE_NULL_HID
  std::string path;
  palpate_device firmware = {};
  bool given = false;
};

namespace {

constexpr char kData = 'D';
constexpr char kFeature = 'F';
constexpr int kNothing = -2;
constexpr const char* kNullPath = "null:";
constexpr const char* kNullFile = "1209-4a01-ff00-50-NULL.sock";

int connectTo(const std::string& path, char purpose) {
  const int descriptor = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  if (connect(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
      send(descriptor, &purpose, 1, MSG_NOSIGNAL) != 1) {
    close(descriptor);
    return -1;
  }
  return descriptor;
}

wchar_t* wide(const char* text) {
  auto* copy = static_cast<wchar_t*>(std::calloc(std::strlen(text) + 1, sizeof(wchar_t)));
  for (size_t i = 0; text[i] != 0; i++) {
    copy[i] = static_cast<wchar_t>(text[i]);
  }
  return copy;
}

hid_device_info* infoOf(const std::string& folder, const char* file) {
  unsigned vendor = 0;
  unsigned product = 0;
  unsigned page = 0;
  unsigned usage = 0;
  char serial[64];
  if (std::sscanf(file, "%x-%x-%x-%x-%63[^.].sock", &vendor, &product, &page, &usage, serial) !=
      5) {
    return nullptr;
  }
  auto* info = static_cast<hid_device_info*>(std::calloc(1, sizeof(hid_device_info)));
  info->path = strdup((folder + "/" + file).c_str());
  info->vendor_id = static_cast<unsigned short>(vendor);
  info->product_id = static_cast<unsigned short>(product);
  info->usage_page = static_cast<unsigned short>(page);
  info->usage = static_cast<unsigned short>(usage);
  info->serial_number = wide(serial);
  info->manufacturer_string = wide("nobody");
  info->product_string = wide("Fake haptic device");
  return info;
}

hid_device* openNothing() {
  auto* device = new hid_device{kNothing, kNullPath};
  palpate_capabilities can = {};
  can.max_force_mn = 6000;
  can.continuous_force_mn = 6000;
  can.max_stiffness_n_per_m = 1500;
  can.workspace_radius_tenth_mm = 600;
  can.report_interval_us = 1000;
  can.watchdog_ms = 20;
  palpate_device_init(&device->firmware, &can);
  return device;
}

int readNothing(hid_device* device, unsigned char* bytes, size_t length) {
  device->given = !device->given;
  if (!device->given || length < PALPATE_IN_BYTES) {
    return 0;
  }
  palpate_pose pose = {};
  pose.calibrated = 1;
  pose.hand_present = 1;
  pose.quaternion[3] = 32767;
  palpate_device_in(&device->firmware, &pose, device->firmware.in_sequence * 1000U, bytes);
  return PALPATE_IN_BYTES;
}

}  // namespace

extern "C" {

int hid_init() { return 0; }

hid_device_info* hid_enumerate(unsigned short, unsigned short) {
  const Call call("hid_enumerate", false);
  const char* folder = std::getenv("PALPATE_FAKE_HID");
  DIR* entries = folder != nullptr && !call.fails() ? opendir(folder) : nullptr;
  hid_device_info* first = nullptr;
  while (entries != nullptr) {
    const dirent* entry = readdir(entries);
    if (entry == nullptr) {
      break;
    }
    hid_device_info* info = infoOf(folder, entry->d_name);
    if (info != nullptr) {
      info->next = first;
      first = info;
    }
  }
  if (entries != nullptr) {
    closedir(entries);
  }
  if (std::getenv("PALPATE_NULL_HID") != nullptr) {
    hid_device_info* info = infoOf("", kNullFile);
    std::free(info->path);
    info->path = strdup(kNullPath);
    info->next = first;
    first = info;
  }
  return first;
}

void hid_free_enumeration(hid_device_info* info) {
  const Call call("hid_free_enumeration", false);
  while (info != nullptr) {
    hid_device_info* next = info->next;
    std::free(info->path);
    std::free(info->serial_number);
    std::free(info->manufacturer_string);
    std::free(info->product_string);
    std::free(info);
    info = next;
  }
}

hid_device* hid_open_path(const char* path) {
  const Call call("hid_open_path", false);
  if (std::strcmp(path, kNullPath) == 0) {
    return openNothing();
  }
  const int descriptor = call.fails() ? -1 : connectTo(path, kData);
  return descriptor < 0 ? nullptr : new hid_device{descriptor, path};
}

int hid_write(hid_device* device, const unsigned char* bytes, size_t length) {
  if (device->socket == kNothing) {
    return static_cast<int>(length);
  }
  const Call call("hid_write");
  if (call.fails()) {
    return -1;
  }
  const ssize_t sent = send(device->socket, bytes, length, MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent < 0 ? -1 : static_cast<int>(sent);
}

int hid_read_timeout(hid_device* device, unsigned char* bytes, size_t length, int millis) {
  if (device->socket == kNothing) {
    return readNothing(device, bytes, length);
  }
  const Call call("hid_read_timeout");
  if (call.fails()) {
    return -1;
  }
  pollfd wait = {device->socket, POLLIN, 0};
  if (poll(&wait, 1, millis) <= 0) {
    return 0;
  }
  const ssize_t got = recv(device->socket, bytes, length, 0);
  if (call.givesNaN() && got > 0) {
    std::memset(bytes + 1, 0xFF, static_cast<size_t>(got) - 1);
  }
  return got <= 0 ? -1 : static_cast<int>(got);
}

int hid_get_feature_report(hid_device* device, unsigned char* bytes, size_t length) {
  if (device->socket == kNothing) {
    palpate_device_feature(&device->firmware, bytes);
    return PALPATE_CAPABILITIES_BYTES;
  }
  const Call call("hid_get_feature_report");
  const int descriptor = call.fails() ? -1 : connectTo(device->path, kFeature);
  if (descriptor < 0) {
    return -1;
  }
  const ssize_t got = recv(descriptor, bytes, length, 0);
  close(descriptor);
  if (call.givesNaN() && got > 0) {
    std::memset(bytes, 0xFF, static_cast<size_t>(got));
  }
  return got <= 0 ? -1 : static_cast<int>(got);
}

int hid_get_report_descriptor(hid_device*, unsigned char* bytes, size_t length) {
  const Call call("hid_get_report_descriptor", false);
  if (call.fails() || length < palpate_report_descriptor_bytes) {
    return -1;
  }
  std::memcpy(bytes, palpate_report_descriptor, palpate_report_descriptor_bytes);
  return static_cast<int>(palpate_report_descriptor_bytes);
}

void hid_close(hid_device* device) {
  const Call call("hid_close");
  close(device->socket);
  delete device;
}

const wchar_t* hid_error(hid_device*) { return L"No such device"; }

const char* hid_version_str() { return "0.13.1-substitute"; }
}
