// Other makers' HID devices: WoodenHaptics, and the SpaceMouse, which has no force.
#include <cmath>
#include <string>

#include "bench.h"
#include "check.h"
#include "device/clock.h"
#include "fake_device.h"
#include "hid/wooden_kinematics.h"

using palpate::ReadStatus;
using palpate::Session;

namespace {

constexpr int64_t kWait = palpate::kNanosPerSecond;

}  // namespace

TEST("the forces of a WoodenHaptics are its Jacobian's, found by moving it a little") {
  const palpate::hid::WoodenArm arm;
  const double counts[3] = {3000, -2100, 1700};
  const double force[3] = {1.5, -0.7, 2.2};
  double angles[3];
  double ampere[3];
  palpate::hid::woodenAngles(arm, counts, angles);
  palpate::hid::woodenCurrents(arm, angles, force, ampere);
  const double motorSign[3] = {1, -1, -1};
  for (int body = 0; body < 3; body++) {
    const double step = 1e-6;
    double moved[3] = {angles[0], angles[1], angles[2]};
    double tip[3];
    double tipMoved[3];
    moved[body] += step;
    palpate::hid::woodenTip(arm, angles, tip);
    palpate::hid::woodenTip(arm, moved, tipMoved);
    double work = 0;
    for (int axis = 0; axis < 3; axis++) {
      work += force[axis] * (tipMoved[axis] - tip[axis]) / step;
    }
    const double gear = arm.bodyDiameterMetre[body] / arm.capstanMetre[body];
    CHECK_NEAR(motorSign[body] * work / gear / arm.torqueConstantNewtonMetrePerAmpere, ampere[body],
               1e-4);
  }
}

TEST("a SpaceMouse moves the point as fast as its cap is pushed, and takes no force") {
  FakeDevice mouse(bench::fakeFolder(), "SPACE1", "256f-c635-1-8");
  const int64_t handle = bench::open("hid", "SPACE1");
  while (!mouse.isOpen()) {
    std::this_thread::yield();
  }
  CHECK_EQUAL(0.0, Session::specification(handle).maxForceNewton);
  const palpate::Sample& sample = Session::frame(handle)->sample;
  CHECK(Session::read(handle) == ReadStatus::kFresh);
  CHECK_EQUAL(0.0, sample.positionMm[0]);
  // Fully to the right, half down, half away from the person: int16, little-endian, full scale 350.
  mouse.sendRaw({1, 94, 1, 81, 255, 175, 0});
  for (int i = 0; i < 500; i++) {
    bench::advanceMillis(1);
    CHECK(Session::read(handle) == ReadStatus::kFresh);
    CHECK(bench::push(handle, 1, 1, 1));
  }
  CHECK_NEAR(40.0, sample.positionMm[0], 1e-9);  // 80 mm/s
  CHECK_NEAR(-20.0, sample.positionMm[1], 1e-9);
  CHECK_NEAR(-20.0, sample.positionMm[2], 1e-9);
  mouse.sendRaw({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  mouse.sendRaw({3, 2, 0});
  mouse.sendRaw({1, 0});
  CHECK(Session::read(handle) == ReadStatus::kFresh);
  CHECK_EQUAL(2U, sample.buttons);
  CHECK_EQUAL(int64_t{1}, Session::frame(handle)->counters.wrongLength);
  bench::advanceMillis(40);
  Session::read(handle);
  CHECK_NEAR(40.0, sample.positionMm[0], 1e-9);
  CHECK(mouse.receive(0) == 0 && mouse.lastOut.empty());
  CHECK(Session::close(handle, kWait) == Session::Closed::kZeroSent);
  CHECK(mouse.lastOut.empty());
}

TEST("a SpaceMouse's point stays within reach however long its cap is pushed") {
  FakeDevice mouse(bench::fakeFolder(), "SPACE1", "046d-c626-1-8");
  const int64_t handle = bench::open("hid", "SPACE1");
  while (!mouse.isOpen()) {
    std::this_thread::yield();
  }
  mouse.sendRaw({1, 0xFF, 0x7F, 0x00, 0x80, 0xFF, 0x7F});
  for (int i = 0; i < 5000; i++) {
    bench::advanceMillis(1);
    Session::read(handle);
  }
  const palpate::Sample& sample = Session::frame(handle)->sample;
  CHECK_EQUAL(100.0, sample.positionMm[0]);
  CHECK_EQUAL(-100.0, sample.positionMm[1]);
  CHECK_EQUAL(-100.0, sample.positionMm[2]);
  mouse.unplug();
  ReadStatus status = ReadStatus::kFresh;
  for (int i = 0; i < 5 && status != ReadStatus::kDisconnected; i++) {
    status = Session::read(handle);
  }
  CHECK(status == ReadStatus::kDisconnected);
  Session::close(handle, kWait);
}

namespace {

/** Returns the report of a WoodenHaptics with these encoder counts. */
std::vector<uint8_t> encoders(int a, int b, int c) {
  std::vector<uint8_t> report(8);
  const int counts[3] = {a, b, c};
  for (size_t body = 0; body < 3; body++) {
    report[2 * body] = static_cast<uint8_t>(counts[body]);
    report[2 * body + 1] = static_cast<uint8_t>(counts[body] >> 8);
  }
  return report;
}

/** Returns the current of a body in the last report that the device received, mA. */
int currentOf(const FakeDevice& device, size_t body) {
  return static_cast<int16_t>(device.lastOut[1 + 2 * body] | device.lastOut[2 + 2 * body] << 8);
}

}  // namespace

TEST(
    "a WoodenHaptics session: places from counts that wrap, currents for forces, zero at the end") {
  FakeDevice wooden(bench::fakeFolder(), "WOOD1", "1234-6-0-0");
  const int64_t handle = bench::open("hid", "WOOD1");
  while (!wooden.isOpen()) {
    std::this_thread::yield();
  }
  CHECK_EQUAL(std::string("WoodenHaptics"), Session::specification(handle).name);
  CHECK(Session::read(handle) == ReadStatus::kRepeated);
  const palpate::hid::WoodenArm arm;
  const palpate::Sample& sample = Session::frame(handle)->sample;
  const double counts[3] = {33000, -2100, 1700};  // the first beyond 16 bits
  for (const int first : {11000, 22000, 33000}) {
    wooden.sendRaw(encoders(first, -2100, 1700));
    CHECK(Session::read(handle) == ReadStatus::kFresh);
  }
  double angles[3];
  double tip[3];
  palpate::hid::woodenAngles(arm, counts, angles);
  palpate::hid::woodenTip(arm, angles, tip);
  for (int axis = 0; axis < 3; axis++) {
    CHECK_NEAR(tip[(axis + 1) % 3] * 1000, sample.positionMm[axis], 1e-9);
  }
  for (int i = 0; i < 800; i++) {
    bench::advanceMillis(1);
    wooden.sendRaw(encoders(33000, -2100, 1700));
    CHECK(Session::read(handle) == ReadStatus::kFresh);
    CHECK(bench::push(handle, 0.5, 1, -0.7));
    wooden.receive(0);
  }
  CHECK_EQUAL(size_t{9}, wooden.lastOut.size());
  CHECK_EQUAL(0, int{wooden.lastOut[0]});
  const double theirs[3] = {-0.7, 0.5, 1};
  double ampere[3];
  palpate::hid::woodenCurrents(arm, angles, theirs, ampere);
  for (size_t body = 0; body < 3; body++) {
    CHECK_NEAR(ampere[body] * 1000, currentOf(wooden, body), 0.5 + 1e-9);
  }
  wooden.sendRaw({1, 2, 3});
  CHECK(Session::read(handle) == ReadStatus::kRepeated);
  CHECK_EQUAL(int64_t{1}, Session::frame(handle)->counters.wrongLength);
  CHECK(Session::close(handle, kWait) == Session::Closed::kZeroSent);
  wooden.receive(0);
  for (size_t body = 0; body < 3; body++) {
    CHECK_EQUAL(0, currentOf(wooden, body));
  }
}
