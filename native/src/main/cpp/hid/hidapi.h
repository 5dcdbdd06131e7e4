#ifndef PALPATE_HID_HIDAPI_H
#define PALPATE_HID_HIDAPI_H

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "device/device.h"

namespace palpate::hid {

/** An open device of hidapi. */
struct Handle;

/** One device of hidapi's list. */
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
 * hidapi 0.13 or newer, loaded at run time; one for the process. Its list and its last error are
 * shared, so a caller holds `lock` while it lists or opens. A handle belongs to one thread at a
 * time.
 */
struct HidApi {
  int (*init)() = nullptr;
  void* (*enumerate)(unsigned short, unsigned short) = nullptr;
  void (*freeEnumeration)(void*) = nullptr;
  Handle* (*openPath)(const char*) = nullptr;
  int (*write)(Handle*, const unsigned char*, size_t) = nullptr;
  int (*readTimeout)(Handle*, unsigned char*, size_t, int) = nullptr;
  int (*getFeature)(Handle*, unsigned char*, size_t) = nullptr;
  int (*getReportDescriptor)(Handle*, unsigned char*, size_t) = nullptr;  // nullptr before 0.14
  void (*close)(Handle*) = nullptr;
  const wchar_t* (*error)(Handle*) = nullptr;
  const char* (*version)() = nullptr;

  std::string library;
  std::string whyNot;  // one line; empty if it can be used
  std::mutex lock;

  /** Returns the one instance of the process. The first call loads the library. */
  static HidApi& instance();

  /** Lists the devices that are connected now. */
  std::vector<Listed> list(Trace& trace);

  /** Returns the last error as ASCII text. */
  std::string lastError(Handle* handle) const;

 private:
  HidApi();
};

}  // namespace palpate::hid

#endif
