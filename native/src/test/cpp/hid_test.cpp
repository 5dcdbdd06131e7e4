#include <cerrno>
#include <cmath>
#include <string>

#include "bench.h"
#include "check.h"
#include "device/clock.h"
#include "fake_device.h"
#include "hid/hid_backend.h"
#include "hid/protocol.h"

using palpate::ReadStatus;
using palpate::Session;

namespace {

constexpr int64_t kWait = palpate::kNanosPerSecond;

/** An open fake device whose hand has held it still. One thread; no real time passes. */
struct Rig {
  FakeDevice device;
  int64_t handle = bench::open("hid", "SN0001");
  uint32_t micros = 0;

  explicit Rig(const palpate_capabilities& can = FakeDevice::capabilities())
      : device(bench::fakeFolder(), "SN0001", FakeDevice::kOurs, can) {
    while (!device.isOpen()) {
      std::this_thread::yield();
    }
  }
  ~Rig() { Session::close(handle, kWait); }

  /**
   * Runs one millisecond: a report, a read and a write. Returns the force of the motors along x, N.
   */
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

TEST("capabilities of another protocol, version or length are told apart") {
  using palpate::hid::CapabilitiesStatus;
  palpate_device firmware;
  const palpate_capabilities can = FakeDevice::capabilities();
  palpate_device_init(&firmware, &can);
  uint8_t report[PALPATE_CAPABILITIES_BYTES];
  palpate_device_feature(&firmware, report);
  palpate::hid::Capabilities unpacked;
  const auto status = [&](size_t length) {
    return palpate::hid::unpackCapabilities(report, length, unpacked);
  };
  CHECK(status(sizeof report) == CapabilitiesStatus::kOk);
  CHECK_EQUAL(6.0, unpacked.maxForceNewton);
  CHECK_EQUAL(1.5, unpacked.maxStiffnessNewtonPerMm);
  CHECK_EQUAL(60.0, unpacked.workspaceRadiusMm);
  CHECK(status(sizeof report - 1) == CapabilitiesStatus::kAnotherReport);
  for (const int at : {0, 2, 5}) {
    report[at]++;
    CHECK(status(sizeof report) == CapabilitiesStatus::kAnotherReport);
    report[at]--;
  }
  report[1] = 2;
  CHECK(status(sizeof report) == CapabilitiesStatus::kNewerVersion);
  report[1] = 0;
  CHECK(status(sizeof report) == CapabilitiesStatus::kOlderVersion);
}

TEST("the firmware itself gives no force while its hand sensor is let go") {
  palpate_device firmware;
  palpate_capabilities can = FakeDevice::capabilities();
  can.flags = PALPATE_HAS_HAND_SENSOR;
  palpate_device_init(&firmware, &can);
  palpate::Wrench wrench;
  wrench.forceNewton[0] = 1;
  uint8_t out[palpate::hid::kOutBytes];
  palpate::hid::packOut(wrench, false, 1, 0, out);
  palpate_device_out(&firmware, out, sizeof out, 1000);
  palpate_pose pose = {};
  uint8_t in[PALPATE_IN_BYTES];
  palpate_motors motors;
  for (const int held : {0, 1, 0}) {
    pose.hand_present = static_cast<uint8_t>(held);
    palpate_device_motors(&firmware, 1500, &motors);
    palpate_device_in(&firmware, &pose, 2000, in);
    palpate_device_motors(&firmware, 2000, &motors);
    CHECK_EQUAL(1000 * held, motors.force_mn[0]);
  }
}

TEST("a virtual wall for a minute at 1 kHz: every force is the right one and none is lost") {
  bench::freshPanel();
  Rig rig;
  rig.settle();
  constexpr double kStiffness = 0.6;  // N/mm, below the governor's slew rate for this hand
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

TEST(
    "a node that must not be opened is answered with the udev rule, one that is not there is not") {
  palpate::hid::Listed listed;
  listed.path = "/dev/hidraw7";
  listed.vendorId = 0x1209;
  listed.productId = 0x4a01;
  CHECK_EQUAL(std::string("no permission on /dev/hidraw7: put this line into "
                          "/etc/udev/rules.d/70-palpate.rules, then plug it in again: "
                          "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1209\", "
                          "ATTRS{idProduct}==\"4a01\", TAG+=\"uaccess\""),
              palpate::hid::refusal(listed, EACCES));
  CHECK_EQUAL(std::string("there is no /dev/hidraw7: in a container, start it with --device "
                          "/dev/hidraw7"),
              palpate::hid::refusal(listed, ENOENT));
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

TEST("a device that is not calibrated says so and gives no force until it is") {
  Rig rig;
  rig.settle();
  rig.device.pose.calibrated = 0;
  CHECK_EQUAL(0.0, rig.frame(1));
  CHECK((rig.sample().flags & palpate::kNeedsCalibration) != 0);
  rig.device.pose.calibrated = 1;
  CHECK_EQUAL(0.0, rig.frame(1));
  CHECK((rig.sample().flags & palpate::kNeedsCalibration) == 0);
  rig.settle();
  CHECK(rig.frame(1) > 0);
}

TEST("a dead-man switch that is let go takes the force away until it is held and still again") {
  palpate_capabilities can = FakeDevice::capabilities();
  can.flags = PALPATE_HAS_HAND_SENSOR;
  Rig rig(can);
  rig.settle();
  CHECK(rig.frame(1) > 0);
  rig.device.pose.hand_present = 0;
  CHECK_EQUAL(0.0, rig.frame(1));
  CHECK((rig.sample().flags & palpate::kForceReady) == 0);
  rig.device.pose.hand_present = 1;
  CHECK_EQUAL(0.0, rig.frame(1));
  rig.settle();
  CHECK(rig.frame(1) > 0);
}

TEST("a device whose capabilities name no workspace or no stiffness is refused") {
  palpate_capabilities nowhere = FakeDevice::capabilities();
  nowhere.workspace_radius_tenth_mm = 0;
  palpate_capabilities soft = FakeDevice::capabilities();
  soft.max_stiffness_n_per_m = 0;
  for (const palpate_capabilities& can : {nowhere, soft}) {
    FakeDevice device(bench::fakeFolder(), "SN0003", FakeDevice::kOurs, can);
    std::string why;
    CHECK_EQUAL(int64_t{0}, Session::open(*palpate::backendNamed("hid"), "SN0003", kWait, why));
    CHECK_EQUAL(std::string("its capabilities name no workspace or no stiffness: "
                            "set them in its firmware"),
                why);
  }
}
