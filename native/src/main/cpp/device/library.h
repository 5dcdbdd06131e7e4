#ifndef PALPATE_DEVICE_LIBRARY_H
#define PALPATE_DEVICE_LIBRARY_H

#include <string>
#include <vector>

namespace palpate {

/**
 * A vendor's shared library, found at run time and never unloaded again: vendors keep threads in
 * theirs. Not for use by two threads at once.
 */
class Library {
 public:
  /**
   * Tries the names in turn, first in the folder that the environment variable `folderVariable`
   * names (where it is not nullptr and set), then where the system looks. Ask isFound after.
   */
  Library(const std::vector<std::string>& names, const char* folderVariable);

  bool isFound() const { return handle_ != nullptr; }

  /** The name that was found, or empty. */
  const std::string& name() const { return name_; }

  /** Fills a function pointer; false, and the name noted as missing, where there is none. */
  template <typename F>
  bool need(const char* symbol, F*& function) {
    function = reinterpret_cast<F*>(find(symbol));
    if (function == nullptr) {
      missing_ += missing_.empty() ? symbol : std::string(", ") + symbol;
    }
    return function != nullptr;
  }

  /** Fills a function pointer where there is one; nullptr else. */
  template <typename F>
  void wish(const char* symbol, F*& function) {
    function = reinterpret_cast<F*>(find(symbol));
  }

  /** Needed functions that were not there, separated by commas. */
  const std::string& missing() const { return missing_; }

  /** One line: which names were looked for and how the last one failed. */
  const std::string& whyNot() const { return whyNot_; }

 private:
  void* find(const char* symbol) const;
  bool tryOpen(const std::string& path);

  void* handle_ = nullptr;
  std::string name_;
  std::string missing_;
  std::string whyNot_;
};

/** A vendor's library: where to look for it, and what to say where it cannot be used. */
struct Wanted {
  std::vector<std::string> names;
  const char* folderVariable;  // or nullptr
  const char* product;         // as in "OpenHaptics is not installed"
  const char* install;         // what to do then
  const char* update;          // what to do where it lacks functions
};

/**
 * Looks for a library and fills the functions of `api`, which has `library` and `whyNot` for what
 * came of it; `fill` asks a Library for each.
 */
template <typename Api, typename Fill>
void findFunctions(const Wanted& wanted, Api& api, Fill fill) {
  Library found(wanted.names, wanted.folderVariable);
  if (!found.isFound()) {
    api.whyNot = std::string(wanted.product) + " is not installed (" + found.whyNot() +
                 "): " + wanted.install;
    return;
  }
  api.library = found.name();
  fill(found);
  if (!found.missing().empty() && api.whyNot.empty()) {
    api.whyNot = api.library + " lacks " + found.missing() + ": " + wanted.update;
  }
}

}  // namespace palpate

#endif
