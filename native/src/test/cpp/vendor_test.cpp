#include <cmath>
#include <string>

#include "bench.h"
#include "check.h"
#include "device/clock.h"

using palpate::Finding;
using palpate::ReadStatus;
using palpate::Session;

namespace {

constexpr int64_t kWait = palpate::kNanosPerSecond;

Finding look(const char* backend) { return Session::probe(*palpate::backendNamed(backend), kWait); }

void pushUntilFelt(int64_t handle, double x, double y, double z) {
  for (int i = 0; i < 60; i++) {
    bench::advanceMillis(1);
    bench::readFresh(handle);
    bench::push(handle, x, y, z);
  }
  bench::readFresh(handle);  // a servo loop has now taken the newest wrench
  bench::readFresh(handle);
}

/** Checks the conversion from a vendor's frame with axes towards the person, right and up. */
void checkTowardsRightUp(const char* backend, double newtonTolerance) {
  substitutes::Panel& panel = bench::freshPanel();
  panel.position[0] = 0.01;
  panel.position[1] = 0.02;
  panel.position[2] = 0.03;
  const int64_t handle = bench::open(backend, "");
  bench::holdStill(handle);
  const palpate::Sample& sample = Session::frame(handle)->sample;
  CHECK_NEAR(20.0, sample.positionMm[0], 1e-5);
  CHECK_NEAR(30.0, sample.positionMm[1], 1e-5);
  CHECK_NEAR(10.0, sample.positionMm[2], 1e-5);
  // A rotation about their z axis, which points up, is one about our y axis.
  CHECK_NEAR(0.0, sample.orientation[0], 1e-6);
  CHECK_NEAR(std::sqrt(0.5), sample.orientation[1], 1e-6);
  CHECK_NEAR(0.0, sample.orientation[2], 1e-6);
  CHECK_NEAR(std::sqrt(0.5), sample.orientation[3], 1e-6);
  pushUntilFelt(handle, 1, 2, 3);
  CHECK_NEAR(3.0, panel.force[0].load(), newtonTolerance);
  CHECK_NEAR(1.0, panel.force[1].load(), newtonTolerance);
  CHECK_NEAR(2.0, panel.force[2].load(), newtonTolerance);
  CHECK(Session::close(handle, kWait) == Session::Closed::kZeroSent);
  CHECK_EQUAL(0.0, panel.force[0].load());
  CHECK_EQUAL(0, panel.openDevices.load());
  CHECK_EQUAL(0, panel.ruleBreaks.load());
  CHECK_EQUAL(0, panel.overlaps.load());
}

/**
 * Opens a Phantom that is held still and sent a force. `notReady` is 1 if it needs the user for
 * calibration, and 2 if it needs an update.
 */
int64_t pushedPhantom(substitutes::Panel& panel, int notReady) {
  panel.notReady = notReady;
  const int64_t handle = bench::open("openhaptics", "");
  bench::holdStill(handle);
  pushUntilFelt(handle, 1, 0, 0);
  return handle;
}

}  // namespace

TEST("Force Dimension's axes, metres and newtons become ours and back") {
  checkTowardsRightUp("forcedimension", 1e-12);
}

TEST("Haption's axes, metres and newtons become ours and back, in the documented order of calls") {
  checkTowardsRightUp("virtuose", 1e-6);
}

TEST("OpenHaptics' axes are ours; forces are set in a frame of the servo loop alone") {
  substitutes::Panel& panel = bench::freshPanel();
  panel.position[0] = 10;
  panel.position[1] = 20;
  panel.position[2] = 30;
  const int64_t handle = bench::open("openhaptics", "");
  const palpate::Specification specification = Session::specification(handle);
  CHECK_EQUAL(std::string("PHANTOM Premium 1.5 6-DOF"), specification.name);
  CHECK_EQUAL(8.5, specification.maxForceNewton);
  CHECK_EQUAL(1.4, specification.continuousForceNewton);
  CHECK_EQUAL(0.8, specification.maxStiffnessNewtonPerMm);
  CHECK_EQUAL(35.0, specification.workspaceRadiusMm);
  CHECK_EQUAL(0.188, specification.maxTorqueNewtonMetre);
  bench::holdStill(handle);
  const palpate::Sample& sample = Session::frame(handle)->sample;
  CHECK_EQUAL(10.0, sample.positionMm[0]);
  CHECK_EQUAL(30.0, sample.positionMm[2]);
  CHECK_NEAR(std::sqrt(0.5), sample.orientation[1], 1e-9);
  CHECK_NEAR(std::sqrt(0.5), sample.orientation[3], 1e-9);
  CHECK_EQUAL(0.25, sample.motorHeat);
  Session::frame(handle)->wrench.torqueNewtonMetre[1] = 0.05;
  pushUntilFelt(handle, 1, 2, -3);
  CHECK_EQUAL(1.0, panel.force[0].load());
  CHECK_EQUAL(-3.0, panel.force[2].load());
  CHECK_EQUAL(50.0, panel.torque[1].load());
  CHECK(Session::close(handle, kWait) == Session::Closed::kZeroSent);
  CHECK_EQUAL(0.0, panel.force[2].load());
  CHECK_EQUAL(0, panel.openDevices.load());
  CHECK_EQUAL(0, panel.ruleBreaks.load());
}

TEST("the servo loop zeroes the force when its host falls silent") {
  substitutes::Panel& panel = bench::freshPanel();
  const int64_t handle = bench::open("openhaptics", "");
  bench::holdStill(handle);
  pushUntilFelt(handle, 1, 0, 0);
  CHECK_EQUAL(1.0, panel.force[0].load());
  bench::advanceMillis(25);
  const int64_t forces = panel.forces;
  while (panel.forces < forces + 3) {
  }
  CHECK_EQUAL(0.0, panel.force[0].load());
  Session::close(handle, kWait);
}

TEST("a device whose dead-man is let go gives no force until it is held and still again") {
  for (const std::string backend : {"openhaptics", "forcedimension", "virtuose"}) {
    substitutes::Panel& panel = bench::freshPanel();
    const int64_t handle = bench::open(backend, "");
    const std::atomic<double>& felt = panel.force[backend == "openhaptics" ? 0 : 1];
    bench::holdStill(handle);
    pushUntilFelt(handle, 1, 0, 0);
    CHECK_NEAR(1.0, felt.load(), 1e-6);
    panel.notReady = 1;
    pushUntilFelt(handle, 1, 0, 0);
    CHECK_EQUAL(0.0, felt.load());
    panel.notReady = 0;
    pushUntilFelt(handle, 1, 0, 0);
    CHECK_EQUAL(0.0, felt.load());
    bench::holdStill(handle);
    pushUntilFelt(handle, 1, 0, 0);
    CHECK_NEAR(1.0, felt.load(), 1e-6);
    Session::close(handle, kWait);
  }
}

TEST("a Phantom that wants a hand's help to calibrate says so and gives no force") {
  substitutes::Panel& panel = bench::freshPanel();
  const int64_t handle = pushedPhantom(panel, 1);
  CHECK((Session::frame(handle)->sample.flags & palpate::kNeedsCalibration) != 0);
  CHECK_EQUAL(0.0, panel.force[0].load());
  Session::close(handle, kWait);
}

TEST("a Phantom whose calibration wants an update gets it in opening") {
  substitutes::Panel& panel = bench::freshPanel();
  const int64_t handle = pushedPhantom(panel, 2);
  CHECK((Session::frame(handle)->sample.flags & palpate::kNeedsCalibration) == 0);
  CHECK_EQUAL(1.0, panel.force[0].load());
  Session::close(handle, kWait);
}

TEST("six degrees of freedom: no torque until one is asked for, then no more than the device's") {
  substitutes::Panel& panel = bench::freshPanel();
  const int64_t handle = bench::open("openhaptics", "");
  bench::holdStill(handle);
  pushUntilFelt(handle, 1, 2, 3);
  for (const std::atomic<double>& component : panel.torque) {
    CHECK_EQUAL(0.0, component.load());
  }
  Session::frame(handle)->wrench.torqueNewtonMetre[0] = 5;
  pushUntilFelt(handle, 1, 2, 3);
  CHECK_NEAR(188.0, panel.torque[0].load(), 1e-9);
  Session::frame(handle)->wrench.torqueNewtonMetre[0] = NAN;
  pushUntilFelt(handle, 1, 2, 3);
  CHECK_EQUAL(0.0, panel.torque[0].load());
  Session::close(handle, kWait);
}

TEST("a Force Dimension device is chosen by its serial, and a wrong one is said") {
  bench::freshPanel();
  const int64_t handle = bench::open("forcedimension", "1234");
  CHECK_EQUAL(std::string("1234"), Session::specification(handle).serial);
  CHECK_EQUAL(std::string("the device's own watchdog, 20 ms"),
              Session::specification(handle).watchdog);
  Session::close(handle, kWait);
  std::string why;
  CHECK_EQUAL(int64_t{0},
              Session::open(*palpate::backendNamed("forcedimension"), "77", kWait, why));
  CHECK_THAT(why.rfind("dhdOpenSerial: ", 0) == 0, why);
  Session::open(*palpate::backendNamed("forcedimension"), "seven", kWait, why);
  CHECK_EQUAL(std::string("a serial number is at most five digits, not seven"), why);
}

TEST("each back end says what it found, and what it did not") {
  substitutes::Panel& panel = bench::freshPanel();
  CHECK_EQUAL(std::string("4.4"), look("virtuose").version);
  CHECK(look("openhaptics").usable);
  CHECK_EQUAL(size_t{1}, look("forcedimension").devices.size());
  panel.noDevices = 1;
  CHECK(!look("forcedimension").usable);
  CHECK_EQUAL(std::string("no Force Dimension device is connected: check its cable and power"),
              look("forcedimension").why);
  CHECK_EQUAL(std::string("no HID haptic device is plugged in"), look("hid").why);
  CHECK_EQUAL(std::string("0.13.1-substitute"), look("hid").version);
}
