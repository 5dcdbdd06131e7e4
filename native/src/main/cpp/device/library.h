#ifndef PALPATE_DEVICE_LIBRARY_H
#define PALPATE_DEVICE_LIBRARY_H

#include <string>
#include <vector>

namespace palpate {

/**
 * A vendor's shared library, which is loaded at run time. It is never unloaded, because it may have
 * threads of its own. One thread at a time.
 */
class Library {
 public:
  /**
   * Tries the names in order: first in the folder that the environment variable `folderVariable`
   * names, if there is one, then where the system looks. isFound reports the outcome.
   */
  Library(const std::vector<std::string>& names, const char* folderVariable);

  bool isFound() const { return handle_ != nullptr; }

  /** Returns the name that was found, or an empty text. */
  const std::string& name() const { return name_; }

  /** Fills a function pointer. If the function is missing, returns false and records its name. */
  template <typename F>
  bool need(const char* symbol, F*& function) {
    function = reinterpret_cast<F*>(find(symbol));
    if (function == nullptr) {
      missing_ += missing_.empty() ? symbol : std::string(", ") + symbol;
    }
    return function != nullptr;
  }

  /** Fills the pointer of a function that may be missing: then with nullptr. */
  template <typename F>
  void wish(const char* symbol, F*& function) {
    function = reinterpret_cast<F*>(find(symbol));
  }

  /** Returns the names of required functions that are missing, separated by commas. */
  const std::string& missing() const { return missing_; }

  /** Returns one line: the names that were tried, and the error of the last one. */
  const std::string& whyNot() const { return whyNot_; }

 private:
  void* find(const char* symbol) const;
  bool tryOpen(const std::string& path);

  void* handle_ = nullptr;
  std::string name_;
  std::string missing_;
  std::string whyNot_;
};

/** A vendor's library: where to look for it, and the messages if it cannot be used. */
struct Wanted {
  std::vector<std::string> names;
  const char* folderVariable;  // or nullptr
  const char* product;         // as in "OpenHaptics is not installed"
  const char* install;         // the remedy then
  const char* update;          // the remedy if functions are missing
};

/**
 * Loads a library and fills the functions of `api`, whose `library` and `whyNot` receive the
 * outcome. `fill` requests each function from a Library.
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
