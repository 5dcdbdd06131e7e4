// Prints what each back end finds on this machine, like `palpate devices` but without a JVM. For
// platforms that are only cross-compiled for.
#include <cstdio>

#include "device/clock.h"
#include "device/session.h"

int main() {
  for (palpate::Backend* backend : palpate::backends()) {
    const palpate::Finding finding =
        palpate::Session::probe(*backend, 5 * palpate::kNanosPerSecond);
    std::printf("%s: %s%s %s %s\n", backend->name(),
                finding.usable ? "usable" : "not usable: ", finding.why.c_str(),
                finding.library.c_str(), finding.version.c_str());
    for (const palpate::FoundDevice& device : finding.devices) {
      std::printf("  %s %s %s\n", device.id.c_str(), device.name.c_str(), device.why.c_str());
    }
  }
  return 0;
}
