#include "device/library.h"

#include <cstdlib>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace palpate {
namespace {

#ifdef _WIN32
constexpr char kFolderEnd = '\\';
void* openLibrary(const std::string& path) {
  return reinterpret_cast<void*>(LoadLibraryA(path.c_str()));
}
std::string lastError() { return "error " + std::to_string(GetLastError()); }
#else
constexpr char kFolderEnd = '/';
void* openLibrary(const std::string& path) { return dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL); }
std::string lastError() {
  const char* text = dlerror();
  return text != nullptr ? text : "unknown error";
}
#endif

}  // namespace

Library::Library(const std::vector<std::string>& names, const char* folderVariable) {
  const char* folder = folderVariable != nullptr ? std::getenv(folderVariable) : nullptr;
  for (const std::string& name : names) {
    if (folder != nullptr && tryOpen(std::string(folder) + kFolderEnd + name)) {
      return;
    }
    if (tryOpen(name)) {
      return;
    }
  }
}

bool Library::tryOpen(const std::string& path) {
  handle_ = openLibrary(path);
  if (handle_ != nullptr) {
    name_ = path;
    whyNot_.clear();
  } else {
    whyNot_ = lastError();
  }
  return handle_ != nullptr;
}

void* Library::find(const char* symbol) const {
#ifdef _WIN32
  return reinterpret_cast<void*>(GetProcAddress(reinterpret_cast<HMODULE>(handle_), symbol));
#else
  return dlsym(handle_, symbol);
#endif
}

}  // namespace palpate
