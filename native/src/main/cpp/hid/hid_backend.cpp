#include "hid/hid_backend.h"

#include <cerrno>
#include <cstdio>

#ifndef _WIN32
#include <unistd.h>
#endif

#include "hid/protocol.h"

namespace palpate::hid {
namespace {

constexpr uint16_t kLogitech = 0x046D;
constexpr uint16_t k3Dconnexion = 0x256F;
constexpr uint16_t kWoodenVendor = 0x1234;
constexpr uint16_t kWoodenProduct = 0x0006;
constexpr uint16_t kGenericDesktop = 0x01;
constexpr uint16_t kMultiAxisController = 0x08;

using Opener = std::unique_ptr<Device> (*)(Link, const Listed&, std::shared_ptr<Trace>,
                                           std::string&);

/** Returns the function that opens a listed device; nullptr if no kind of device matches. */
Opener openerOf(const Listed& listed) {
  if (listed.usagePage == kUsagePage && listed.usage == kUsage) {
    return openProtocolDevice;
  }
  if (listed.vendorId == kWoodenVendor && listed.productId == kWoodenProduct) {
    return openWoodenHaptics;
  }
  const bool maker = listed.vendorId == kLogitech || listed.vendorId == k3Dconnexion;
  const bool axes = listed.usagePage == kGenericDesktop && listed.usage == kMultiAxisController;
  return maker && axes ? openSpaceMouse : nullptr;
}

std::string hex4(uint16_t value) {
  char text[5];
  std::snprintf(text, sizeof text, "%04x", value);
  return text;
}

std::string idOf(const Listed& listed) {
  return listed.serial.empty() ? listed.path : listed.serial;
}

/** Returns the reason why this user may not open the device's node; empty if it can be opened. */
std::string permission(const Listed& listed) {
#ifdef __linux__
  const bool node = listed.path.rfind("/dev/", 0) == 0;
  if (node && access(listed.path.c_str(), R_OK | W_OK) != 0) {
    return refusal(listed, errno);
  }
#else
  (void)listed;
#endif
  return "";
}

FoundDevice found(const Listed& listed) {
  FoundDevice device;
  device.id = idOf(listed);
  device.name = listed.product.empty() ? hex4(listed.vendorId) + ":" + hex4(listed.productId)
                                       : listed.product;
  device.why = permission(listed);
  device.usable = device.why.empty();
  return device;
}

std::string noneLike(const std::string& id, const std::vector<Listed>& all) {
  std::string seen;
  for (const Listed& listed : all) {
    if (openerOf(listed) != nullptr) {
      seen += (seen.empty() ? "" : ", ") + idOf(listed);
    }
  }
  if (seen.empty()) {
    return "no HID haptic device is plugged in: plug one in";
  }
  return "no HID device has the serial " + id + ": use one of " + seen;
}

}  // namespace

std::string refusal(const Listed& listed, int error) {
  if (error == ENOENT) {
    return "there is no " + listed.path + ": in a container, start it with --device " + listed.path;
  }
  return "no permission on " + listed.path +
         ": put this line into /etc/udev/rules.d/70-palpate.rules, then plug it in again: "
         "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"" +
         hex4(listed.vendorId) + "\", ATTRS{idProduct}==\"" + hex4(listed.productId) +
         "\", TAG+=\"uaccess\"";
}

void Link::close(Trace* trace) {
  Handle* handle = handle_;
  handle_ = nullptr;
  if (handle == nullptr) {
    return;
  }
  if (trace != nullptr) {
    traced(*trace, "hid_close", api_->close, handle);
  } else {
    api_->close(handle);
  }
}

void Link::failed(const char* call, int& inARow, Trace& trace, Counters& counters) {
  counters.errors++;
  if (++inARow >= kMostFailures) {
    gone_ = true;
    trace.end(std::string("the device is gone: ") + call + ": " + api_->lastError(handle_));
  }
}

int Link::read(uint8_t* bytes, size_t length, Trace& trace, Counters& counters) {
  const int got =
      gone_ ? -1 : traced(trace, "hid_read_timeout", api_->readTimeout, handle_, bytes, length, 0);
  if (got >= 0) {
    failedReads_ = 0;
    return got;
  }
  if (!gone_) {
    failed("hid_read_timeout", failedReads_, trace, counters);
  }
  return gone_ ? -1 : 0;
}

bool Link::send(const uint8_t* bytes, size_t length, Trace& trace) {
  return traced(trace, "hid_write", api_->write, handle_, bytes, length) ==
         static_cast<int>(length);
}

bool Link::write(const uint8_t* bytes, size_t length, Trace& trace, Counters& counters) {
  if (gone_) {
    return false;
  }
  if (send(bytes, length, trace)) {
    failedWrites_ = 0;
  } else {
    failed("hid_write", failedWrites_, trace, counters);
  }
  return !gone_;
}

bool Link::closeWith(const uint8_t* bytes, size_t length, Trace& trace) {
  bool sent = false;
  for (int i = 0; i < kGoodbyes && !sent; i++) {
    sent = send(bytes, length, trace);
  }
  close(&trace);
  return sent;
}

Finding HidBackend::probe(Trace& trace) {
  HidApi& api = HidApi::instance();
  Finding finding;
  finding.library = api.library;
  finding.why = api.whyNot;
  if (!finding.why.empty()) {
    return finding;
  }
  finding.version = api.version();
  const std::lock_guard<std::mutex> guard(api.lock);
  for (const Listed& listed : api.list(trace)) {
    if (openerOf(listed) != nullptr) {
      finding.devices.push_back(found(listed));
      finding.usable = finding.usable || finding.devices.back().usable;
    }
  }
  if (finding.devices.empty()) {
    finding.why = "no HID haptic device is plugged in";
  } else if (!finding.usable) {
    finding.why = finding.devices.front().why;
  }
  return finding;
}

/** The handle of the requested device, and the function that makes a device from it. */
struct HidBackend::Opened {
  Handle* handle = nullptr;
  Listed listed;
  Opener opener = nullptr;
};

HidBackend::Opened HidBackend::openHandle(const std::string& id, Trace& trace, std::string& why) {
  HidApi& api = HidApi::instance();
  why = api.whyNot;
  if (!why.empty()) {
    return {};
  }
  const std::vector<Listed> all = api.list(trace);
  for (const Listed& listed : all) {
    const Opener opener = openerOf(listed);
    if (opener == nullptr || (!id.empty() && id != idOf(listed) && id != listed.path)) {
      continue;
    }
    why = permission(listed);
    if (!why.empty()) {
      return {};
    }
    Handle* handle = traced(trace, "hid_open_path", api.openPath, listed.path.c_str());
    if (handle == nullptr) {
      why = "hid_open_path " + listed.path + ": " + api.lastError(nullptr);
    }
    return {handle, listed, opener};
  }
  why = noneLike(id, all);
  return {};
}

std::unique_ptr<Device> HidBackend::open(const std::string& id, std::shared_ptr<Trace> trace,
                                         std::string& why) {
  HidApi& api = HidApi::instance();
  const std::lock_guard<std::mutex> guard(api.lock);
  const Opened opened = openHandle(id, *trace, why);
  if (opened.handle == nullptr) {
    return nullptr;
  }
  return opened.opener(Link(api, opened.handle), opened.listed, std::move(trace), why);
}

std::string HidBackend::capture(const std::string& id, Trace& trace, std::string& why) {
  HidApi& api = HidApi::instance();
  std::unique_lock<std::mutex> guard(api.lock);
  const Opened opened = openHandle(id, trace, why);
  guard.unlock();
  if (opened.handle == nullptr) {
    return "";
  }
  const Link link(api, opened.handle);
  if (opened.opener != openProtocolDevice) {
    why = idOf(opened.listed) + " does not speak the protocol: capture a hand-built device";
    return "";
  }
  return captureDevice(link, opened.listed, trace);
}

}  // namespace palpate::hid
