#include <cmath>
#include <string>

#include "bench.h"
#include "check.h"
#include "device/clock.h"
#include "fake_device.h"
#include "hid/protocol.h"
#include "hid/wooden_kinematics.h"

using palpate::ReadStatus;
using palpate::Session;

namespace {

constexpr int64_t kWait = palpate::kNanosPerSecond;

/** A fake device that is open, with a hand that has held it still: one thread, no real time. */
struct Rig {
  FakeDevice device{bench::fakeFolder(), "SN0001"};
  int64_t handle = bench::open("hid", "SN0001");
  uint32_t micros = 0;

  Rig() {
    while (!device.isOpen()) {
      std::this_thread::yield();
    }
  }
  ~Rig() { Session::close(handle, kWait); }

  /** One millisecond: a report, a read, a write, and what the motors then do along x, in N. */
  double frame(double newton) {
    micros += 1000;
    bench::advanceMillis(1);
    device.step(micros);
    CHECK(Session::read(handle) == ReadStatus::kFresh);
    CHECK(bench::push(handle, newton, 0, 0));
    CHECK_EQUAL(1, device.receive(micros));
    return device.motors(micros).force_mn[0] / 1000.0;
  }

  void settle() {
    for (int i = 0; i < 800; i++) {
      frame(0);
    }
  }

  palpate::Counters counters() const { return Session::frame(handle)->counters; }
  const palpate::Sample& sample() const { return Session::frame(handle)->sample; }
};

}  // namespace

TEST("what the firmware packs is what the host unpacks") {
  palpate_device firmware;
  const palpate_capabilities can = FakeDevice::capabilities();
  palpate_device_init(&firmware, &can);
  palpate_pose pose = {};
  pose.position_um[0] = -123456;
  pose.position_um[1] = 2147483647;
  pose.position_um[2] = 1;
  pose.quaternion[1] = 23170;
  pose.quaternion[3] = -23170;
  pose.buttons = 0x8001;
  pose.gripper_10um = -250;
  pose.calibrated = 1;
  pose.hand_present = 1;
  pose.motor_heat = 51;
  uint8_t report[PALPATE_IN_BYTES];
  palpate_device_in(&firmware, &pose, 4000000000U, report);
  const palpate::hid::InReport in = palpate::hid::unpackIn(report);
  CHECK_EQUAL(1, in.sequence);
  CHECK_EQUAL(4000000000U, in.timeMicros);
  CHECK_EQUAL(-123.456, in.sample.positionMm[0]);
  CHECK_EQUAL(2147483.647, in.sample.positionMm[1]);
  CHECK_EQUAL(0.001, in.sample.positionMm[2]);
  CHECK_NEAR(std::sqrt(0.5), in.sample.orientation[1], 1e-9);
  CHECK_NEAR(-std::sqrt(0.5), in.sample.orientation[3], 1e-9);
  CHECK_EQUAL(0x8001U, in.sample.buttons);
  CHECK_EQUAL(-2.5, in.sample.gripperMm);
  CHECK_EQUAL(0.2, in.sample.motorHeat);
  CHECK_EQUAL(uint32_t{palpate::kForceReady}, in.sample.flags);
}

TEST("what the host packs is what the firmware's motors do, within the device's limit") {
  palpate_device firmware;
  const palpate_capabilities can = FakeDevice::capabilities();
  palpate_device_init(&firmware, &can);
  palpate::Wrench wrench;
  wrench.forceNewton[0] = -1.2344;
  wrench.forceNewton[1] = 1e300;
  wrench.forceNewton[2] = 5.9996;
  uint8_t report[palpate::hid::kOutBytes];
  palpate::hid::packOut(wrench, false, 9, 77, report);
  CHECK_EQUAL(1, palpate_device_out(&firmware, report, sizeof report, 1000));
  palpate_motors motors;
  palpate_device_motors(&firmware, 2000, &motors);
  CHECK_EQUAL(-1234, motors.force_mn[0]);
  CHECK_EQUAL(6000, motors.force_mn[1]);
  CHECK_EQUAL(6000, motors.force_mn[2]);
  CHECK_EQUAL(9, firmware.out_sequence);
  CHECK_EQUAL(77U, firmware.echoed_us);
}

TEST("the firmware zeroes its motors after 20 ms of silence, across the wrap of its clock too") {
  for (const uint32_t start : {5000U, 0xFFFFFFFFU - 10000U}) {
    palpate_device firmware;
    const palpate_capabilities can = FakeDevice::capabilities();
    palpate_device_init(&firmware, &can);
    palpate::Wrench wrench;
    wrench.forceNewton[0] = 1;
    uint8_t report[palpate::hid::kOutBytes];
    palpate::hid::packOut(wrench, false, 1, 0, report);
    palpate_device_out(&firmware, report, sizeof report, start);
    palpate_motors motors;
    for (uint32_t elapsed = 0; elapsed < 40000; elapsed += 1000) {
      palpate_device_motors(&firmware, start + elapsed, &motors);
      CHECK_EQUAL(elapsed < 20000 ? 1000 : 0, motors.force_mn[0]);
    }
    CHECK_EQUAL(1, firmware.watchdog_trips);
  }
}

TEST("capabilities of another protocol, version or length are refused") {
  palpate_device firmware;
  const palpate_capabilities can = FakeDevice::capabilities();
  palpate_device_init(&firmware, &can);
  uint8_t report[PALPATE_CAPABILITIES_BYTES];
  palpate_device_feature(&firmware, report);
  palpate::hid::Capabilities unpacked;
  CHECK(palpate::hid::unpackCapabilities(report, sizeof report, unpacked));
  CHECK_EQUAL(6.0, unpacked.maxForceNewton);
  CHECK_EQUAL(1.5, unpacked.maxStiffnessNewtonPerMm);
  CHECK_EQUAL(60.0, unpacked.workspaceRadiusMm);
  CHECK(!palpate::hid::unpackCapabilities(report, sizeof report - 1, unpacked));
  for (const int at : {0, 1, 2, 5}) {
    report[at]++;
    CHECK(!palpate::hid::unpackCapabilities(report, sizeof report, unpacked));
    report[at]--;
  }
}

TEST("a virtual wall for a minute at 1 kHz: every force is the right one and none is lost") {
  bench::freshPanel();
  Rig rig;
  rig.settle();
  constexpr double kStiffness = 0.6;  // N/mm, under the governor's slew for this hand
  int64_t pressed = 0;
  for (int i = 0; i < 60000; i++) {
    const double handMm = 3 * std::sin(i * 0.006);
    rig.device.pose.position_um[0] = static_cast<int32_t>(std::lround(handMm * 1000));
    const double depthMm = std::max(0.0, rig.device.pose.position_um[0] / 1000.0);
    const double felt = rig.frame(-kStiffness * depthMm);
    CHECK_NEAR(-kStiffness * depthMm, felt, 0.0005 + 1e-9);
    CHECK_EQUAL(handMm > 0 ? rig.device.pose.position_um[0] / 1000.0 : rig.sample().positionMm[0],
                rig.sample().positionMm[0]);
    pressed += depthMm > 0 ? 1 : 0;
  }
  CHECK(pressed > 25000);
  CHECK_EQUAL(int64_t{60800}, rig.counters().samples);
  CHECK_EQUAL(int64_t{0}, rig.counters().lost + rig.counters().merged + rig.counters().late);
}

TEST("of several reports at once the newest counts, whether apart or joined") {
  Rig rig;
  rig.frame(0);
  const int64_t before = rig.counters().merged;
  for (int i = 1; i <= 3; i++) {
    rig.device.pose.position_um[0] = 1000 * i;
    rig.device.step(rig.micros + 1000U * static_cast<uint32_t>(i));
  }
  CHECK(Session::read(rig.handle) == ReadStatus::kFresh);
  CHECK_EQUAL(3.0, rig.sample().positionMm[0]);
  std::vector<uint8_t> joined = rig.device.nextReport(rig.micros + 4000);
  rig.device.pose.position_um[0] = 5000;
  const std::vector<uint8_t> second = rig.device.nextReport(rig.micros + 5000);
  joined.insert(joined.end(), second.begin(), second.end());
  rig.device.sendRaw(joined);
  CHECK(Session::read(rig.handle) == ReadStatus::kFresh);
  CHECK_EQUAL(5.0, rig.sample().positionMm[0]);
  CHECK_EQUAL(before + 3, rig.counters().merged);  // two of the three, one of the two
}

TEST("lost, duplicated, late and out of order reports are told apart and counted") {
  Rig rig;
  rig.frame(0);
  rig.device.firmware.in_sequence = static_cast<uint16_t>(rig.device.firmware.in_sequence + 4);
  rig.frame(0);
  CHECK_EQUAL(int64_t{4}, rig.counters().lost);
  rig.device.firmware.in_sequence--;
  rig.device.step(rig.micros);
  CHECK(Session::read(rig.handle) == ReadStatus::kRepeated);
  CHECK_EQUAL(int64_t{1}, rig.counters().duplicated);
  rig.device.firmware.in_sequence = static_cast<uint16_t>(rig.device.firmware.in_sequence - 3);
  rig.device.step(rig.micros);
  CHECK(Session::read(rig.handle) == ReadStatus::kRepeated);
  CHECK_EQUAL(int64_t{1}, rig.counters().outOfOrder);
  rig.device.firmware.in_sequence = static_cast<uint16_t>(rig.device.firmware.in_sequence + 2);
  const int64_t late = rig.counters().late;
  bench::advanceMillis(10);
  rig.frame(0);
  CHECK_EQUAL(late + 1, rig.counters().late);
}

TEST("a sequence that wraps goes on, one that starts anew is followed after a while") {
  Rig rig;
  rig.device.firmware.in_sequence = 65533;
  rig.frame(0);
  const int64_t lost = rig.counters().lost;
  for (int i = 0; i < 5; i++) {
    rig.frame(0);
  }
  CHECK_EQUAL(lost, rig.counters().lost);
  rig.device.firmware.in_sequence = 60000;
  int repeated = 0;
  rig.device.step(rig.micros);
  while (Session::read(rig.handle) == ReadStatus::kRepeated && repeated < 100) {
    repeated++;
    rig.device.step(rig.micros);
  }
  CHECK_EQUAL(31, repeated);
}

TEST("reports of the wrong length or kind are dropped and counted") {
  Rig rig;
  rig.frame(0);
  std::vector<uint8_t> bytes = rig.device.nextReport(rig.micros);
  for (const size_t length : {size_t{1}, size_t{47}, size_t{49}, size_t{100}}) {
    bytes.resize(length);
    rig.device.sendRaw(bytes);
    CHECK(Session::read(rig.handle) == ReadStatus::kRepeated);
  }
  bytes.assign(48, 0);
  rig.device.sendRaw(bytes);
  CHECK(Session::read(rig.handle) == ReadStatus::kRepeated);
  CHECK_EQUAL(int64_t{5}, rig.counters().wrongLength);
  rig.frame(0);
}

TEST("two devices are told apart by serial and each gets its own force") {
  Rig first;
  FakeDevice other(bench::fakeFolder(), "SN0002");
  const int64_t handle = bench::open("hid", "SN0002");
  while (!other.isOpen()) {
    std::this_thread::yield();
  }
  CHECK_EQUAL(std::string("SN0002"), Session::specification(handle).serial);
  for (int i = 1; i <= 1000; i++) {
    first.frame(1);
    other.step(static_cast<uint32_t>(i) * 1000);
    CHECK(Session::read(handle) == ReadStatus::kFresh);
    bench::push(handle, -2, 0, 0);
    other.receive(static_cast<uint32_t>(i) * 1000);
  }
  CHECK_EQUAL(1.0, first.frame(1));
  CHECK_EQUAL(-2000, other.motors(1000000).force_mn[0]);
  Session::close(handle, kWait);
  CHECK_EQUAL(1.0, first.frame(1));
}

TEST("a serial that is not there is answered with those that are") {
  Rig rig;
  std::string why;
  CHECK_EQUAL(int64_t{0}, Session::open(*palpate::backendNamed("hid"), "SN9", kWait, why));
  CHECK_EQUAL(std::string("no HID device has the serial SN9: use one of SN0001"), why);
}

TEST("pulling the plug ends the session with one line") {
  Rig rig;
  rig.frame(0);
  rig.device.unplug();
  for (int i = 0; i < 4; i++) {
    CHECK(Session::read(rig.handle) == ReadStatus::kRepeated);
  }
  CHECK(Session::read(rig.handle) == ReadStatus::kDisconnected);
  CHECK_EQUAL(std::string("the device is gone: hid_read_timeout: No such device"),
              Session::ending(rig.handle));
  CHECK(!Session::write(rig.handle));
  CHECK(Session::close(rig.handle, kWait) == Session::Closed::kUnreachable);
}

TEST("closing sends zero and says that nothing follows") {
  Rig rig;
  rig.settle();
  for (int i = 0; i < 20; i++) {
    rig.frame(3);
  }
  CHECK_EQUAL(3.0, rig.frame(3));
  CHECK(Session::close(rig.handle, kWait) == Session::Closed::kZeroSent);
  rig.device.receive(rig.micros);
  CHECK_EQUAL(0, rig.device.motors(rig.micros).force_mn[0]);
  CHECK_EQUAL(size_t{24}, rig.device.lastOut.size());
  CHECK_EQUAL(2, int{rig.device.lastOut[1]});
  CHECK_EQUAL(std::string(), Session::ending(rig.handle));
}

TEST("a fault that the device reports takes the force away, a grave one ends the session") {
  Rig rig;
  rig.settle();
  CHECK(rig.frame(1) > 0);
  rig.device.pose.fault = PALPATE_FAULT_POWER;
  CHECK_EQUAL(0.0, rig.frame(1));
  rig.device.pose.fault = PALPATE_FAULT_MOTOR;
  rig.device.step(rig.micros);
  CHECK(Session::read(rig.handle) == ReadStatus::kDisconnected);
  CHECK_EQUAL(std::string("the device reports fault 129: switch it off and on"),
              Session::ending(rig.handle));
}

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
  // Full to the right, half down, half away from the person: int16, little-endian, of 350.
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

/** Encoder counts as a WoodenHaptics reports them. */
std::vector<uint8_t> encoders(int a, int b, int c) {
  std::vector<uint8_t> report(8);
  const int counts[3] = {a, b, c};
  for (size_t body = 0; body < 3; body++) {
    report[2 * body] = static_cast<uint8_t>(counts[body]);
    report[2 * body + 1] = static_cast<uint8_t>(counts[body] >> 8);
  }
  return report;
}

/** The current of a body in the last report that the device was sent, mA. */
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
