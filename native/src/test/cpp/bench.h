#ifndef PALPATE_BENCH_H
#define PALPATE_BENCH_H

#include <string>

#include "device/session.h"
#include "substitutes/panel.h"

/** What the tests share: the panel, the folder of fake HID devices, a clock that they move. */
namespace bench {

/** The folder whose sockets are HID devices; made once, named in the environment. */
const std::string& fakeFolder();

/** The panel as new; it is named in the environment before a substitute is loaded. */
substitutes::Panel& freshPanel();

/** Moves the clock on. */
void advanceMillis(int millis);

/** Opens or fails the test; 0 then. */
int64_t open(const std::string& backend, const std::string& id);

/** Reads until there is something new or the device is gone, in real time at most 200 ms. */
palpate::ReadStatus readFresh(int64_t handle);

/** Writes one force; false where the device was not reached. */
bool push(int64_t handle, double x, double y, double z);

/** Holds still until the soft start has let the whole force in. */
void holdStill(int64_t handle);

}  // namespace bench

#endif
