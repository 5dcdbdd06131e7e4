#ifndef PALPATE_BENCH_H
#define PALPATE_BENCH_H

#include <string>

#include "device/session.h"
#include "substitutes/panel.h"

/** Helpers of all tests: the panel, the folder of fake HID devices, and a clock that tests set. */
namespace bench {

/**
 * Returns the folder whose sockets are HID devices. Makes it once and names it in the environment.
 */
const std::string& fakeFolder();

/** Resets the panel and returns it. The environment names it before a substitute is loaded. */
substitutes::Panel& freshPanel();

/** Advances the clock. */
void advanceMillis(int millis);

/** Opens a device and returns its handle. If that is impossible, fails the test and returns 0. */
int64_t open(const std::string& backend, const std::string& id);

/** Reads until there is a new sample or the device is gone, for at most 200 ms of real time. */
palpate::ReadStatus readFresh(int64_t handle);

/** Writes one force. Returns false if the device could not be reached. */
bool push(int64_t handle, double x, double y, double z);

/** Holds the device still until the soft start permits the whole force. */
void holdStill(int64_t handle);

}  // namespace bench

#endif
