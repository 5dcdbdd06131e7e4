#include "hid/hidapi.h"

#include <cwchar>

#include "device/library.h"

namespace palpate::hid {
namespace {

/** An entry of hidapi's list, with the layout of its header since version 0.8. */
struct Info {
  char* path;
  unsigned short vendorId;
  unsigned short productId;
  wchar_t* serialNumber;
  unsigned short releaseNumber;
  wchar_t* manufacturer;
  wchar_t* product;
  unsigned short usagePage;
  unsigned short usage;
  int interfaceNumber;
  Info* next;
};

std::string plain(const wchar_t* wide) {
  std::string text;
  for (; wide != nullptr && *wide != 0; wide++) {
    text.push_back(*wide >= ' ' && *wide <= '~' ? static_cast<char>(*wide) : '?');
  }
  return text;
}

std::vector<std::string> names() {
#if defined(_WIN32)
  return {"hidapi.dll", "libhidapi-0.dll"};
#elif defined(__APPLE__)
  return {"libhidapi.0.dylib", "libhidapi.dylib", "/opt/homebrew/lib/libhidapi.dylib",
          "/usr/local/lib/libhidapi.dylib"};
#else
  return {"libhidapi-hidraw.so.0", "libhidapi-libusb.so.0"};
#endif
}

const char* howToInstall() {
#if defined(_WIN32)
  return "put hidapi.dll beside the program";
#elif defined(__APPLE__)
  return "brew install hidapi";
#else
  return "apt-get install libhidapi-hidraw0";
#endif
}

Listed listed(const Info& info) {
  Listed device;
  device.path = info.path != nullptr ? info.path : "";
  device.serial = plain(info.serialNumber);
  device.product = plain(info.product);
  device.vendorId = info.vendorId;
  device.productId = info.productId;
  device.usagePage = info.usagePage;
  device.usage = info.usage;
  return device;
}

}  // namespace

HidApi& HidApi::instance() {
  static auto* api = new HidApi();  // outlives a thread that hangs in it
  return *api;
}

HidApi::HidApi() {
  const Wanted wanted{names(), nullptr, "hidapi", howToInstall(), "install hidapi 0.13 or newer"};
  findFunctions(wanted, *this, [this](Library& found) {
    found.need("hid_init", init);
    found.need("hid_enumerate", enumerate);
    found.need("hid_free_enumeration", freeEnumeration);
    found.need("hid_open_path", openPath);
    found.need("hid_write", write);
    found.need("hid_read_timeout", readTimeout);
    found.need("hid_get_feature_report", getFeature);
    found.wish("hid_get_report_descriptor", getReportDescriptor);
    found.need("hid_close", close);
    found.need("hid_error", error);
    found.need("hid_version_str", version);
  });
  if (whyNot.empty() && init() != 0) {
    whyNot = library + " does not start: " + lastError(nullptr);
  }
}

std::vector<Listed> HidApi::list(Trace& trace) {
  std::vector<Listed> all;
  void* first = traced(trace, "hid_enumerate", enumerate, 0, 0);
  for (const Info* info = static_cast<const Info*>(first); info != nullptr; info = info->next) {
    all.push_back(listed(*info));
  }
  if (first != nullptr) {
    traced(trace, "hid_free_enumeration", freeEnumeration, first);
  }
  return all;
}

std::string HidApi::lastError(Handle* handle) const { return plain(error(handle)); }

}  // namespace palpate::hid
