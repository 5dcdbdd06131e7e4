#ifndef PALPATE_HID_HIDAPI_H
#define PALPATE_HID_HIDAPI_H

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "device/device.h"

namespace palpate::hid {

/** An opened device of hidapi's. */
struct Handle;

/** One device as hidapi lists it, in our words. */
struct Listed {
  std::string path;
  std::string serial;
  std::string product;
  uint16_t vendorId = 0;
  uint16_t productId = 0;
  uint16_t usagePage = 0;
  uint16_t usage = 0;
};

/**
 * hidapi 0.13 or newer, found at run time. One for the process: its list and its last error are
 * shared, so what lists and opens holds `lock`; a handle belongs to one thread at a time.
 */
struct HidApi {
  int (*init)() = nullptr;
  void* (*enumerate)(unsigned short, unsigned short) = nullptr;
  void (*freeEnumeration)(void*) = nullptr;
  Handle* (*openPath)(const char*) = nullptr;
  int (*write)(Handle*, const unsigned char*, size_t) = nullptr;
  int (*readTimeout)(Handle*, unsigned char*, size_t, int) = nullptr;
  int (*getFeature)(Handle*, unsigned char*, size_t) = nullptr;
  int (*getReportDescriptor)(Handle*, unsigned char*, size_t) = nullptr;  // since 0.14; or nullptr
  void (*close)(Handle*) = nullptr;
  const wchar_t* (*error)(Handle*) = nullptr;
  const char* (*version)() = nullptr;

  std::string library;
  std::string whyNot;  // one line; empty where it can be used
  std::mutex lock;

  /** The process's own, looked for on the first call. */
  static HidApi& instance();

  /** Lists what is plugged in now. */
  std::vector<Listed> list(Trace& trace);

  /** The last error in plain letters. */
  std::string lastError(Handle* handle) const;

 private:
  HidApi();
};

}  // namespace palpate::hid

#endif
