#include "palpate_device.h"

#include <string.h>

const uint8_t palpate_report_descriptor[] = {
    0x06, 0x00,
    0xFF,       /* usage page 0xFF00, vendor defined */
    0x09, 0x50, /* usage 0x50 */
    0xA1, 0x01, /* collection, application */
    0x15, 0x00, /*   bytes from 0 .. */
    0x26, 0xFF,
    0x00,                          /*   .. to 255 */
    0x75, 0x08,                    /*   8 bits each */
    0x85, PALPATE_IN_ID,           /*   report 1 */
    0x09, 0x51,                    /*   usage 0x51 */
    0x95, 47,                      /*   47 of them after the id */
    0x81, 0x02,                    /*   input: data, variable, absolute */
    0x85, PALPATE_OUT_ID,          /*   report 2 */
    0x09, 0x52,                    /*   usage 0x52 */
    0x95, 23,                      /*   23 of them */
    0x91, 0x02,                    /*   output */
    0x85, PALPATE_CAPABILITIES_ID, /* report 3 */
    0x09, 0x53,                    /*   usage 0x53 */
    0x95, 31,                      /*   31 of them */
    0xB1, 0x02,                    /*   feature */
    0xC0,                          /* end of collection */
};
const size_t palpate_report_descriptor_bytes = sizeof(palpate_report_descriptor);

/* Writes little-endian bytes on every processor. */
static void put16(uint8_t* to, uint16_t value) {
  to[0] = (uint8_t)value;
  to[1] = (uint8_t)(value >> 8);
}

static void put32(uint8_t* to, uint32_t value) {
  put16(to, (uint16_t)value);
  put16(to + 2, (uint16_t)(value >> 16));
}

static uint16_t get16(const uint8_t* from) { return (uint16_t)(from[0] | from[1] << 8); }

static uint32_t get32(const uint8_t* from) { return get16(from) | (uint32_t)get16(from + 2) << 16; }

static int16_t clamp(int16_t value, uint16_t most) {
  const int32_t limit = most > 32767 ? 32767 : most;
  return (int16_t)(value > limit ? limit : value < -limit ? -limit : value);
}

static uint8_t has_hand_sensor(const palpate_device* device) {
  return (device->capabilities.flags & PALPATE_HAS_HAND_SENSOR) != 0;
}

void palpate_device_init(palpate_device* device, const palpate_capabilities* capabilities) {
  memset(device, 0, sizeof *device);
  device->capabilities = *capabilities;
  device->hand_away = has_hand_sensor(device);
}

int palpate_device_out(palpate_device* device, const uint8_t* report, size_t length,
                       uint32_t now_us) {
  int axis;
  if (length != PALPATE_OUT_BYTES || report[0] != PALPATE_OUT_ID) {
    return 0;
  }
  device->force_on = (report[1] & PALPATE_WANT_FORCE) != 0 && (report[1] & PALPATE_ENDING) == 0;
  device->out_sequence = get16(report + 2);
  for (axis = 0; axis < 3; axis++) {
    device->wanted.force_mn[axis] = (int16_t)get16(report + 4 + 2 * axis);
    device->wanted.torque_tenth_mnm[axis] = (int16_t)get16(report + 10 + 2 * axis);
  }
  device->wanted.gripper_mn = (int16_t)get16(report + 16);
  device->echoed_us = get32(report + 20);
  device->heard_us = now_us;
  device->listening = 1;
  return 1;
}

static uint8_t state_flags(const palpate_device* device, const palpate_pose* pose) {
  uint8_t flags = 0;
  if (pose->calibrated) flags |= PALPATE_CALIBRATED;
  if (!device->hand_away) flags |= PALPATE_HAND_PRESENT;
  if (device->force_on) flags |= PALPATE_FORCE_ON;
  if (device->zeroed) flags |= PALPATE_WATCHDOG_ZEROED;
  if (pose->fault == PALPATE_FAULT_HOT) flags |= PALPATE_MOTORS_HOT;
  return flags;
}

void palpate_device_in(palpate_device* device, const palpate_pose* pose, uint32_t now_us,
                       uint8_t report[PALPATE_IN_BYTES]) {
  int i;
  memset(report, 0, PALPATE_IN_BYTES);
  device->hand_away = has_hand_sensor(device) && !pose->hand_present;
  report[0] = PALPATE_IN_ID;
  report[1] = state_flags(device, pose);
  put16(report + 2, ++device->in_sequence);
  put32(report + 4, now_us);
  for (i = 0; i < 3; i++) {
    put32(report + 8 + 4 * i, (uint32_t)pose->position_um[i]);
    put16(report + 28 + 2 * i, (uint16_t)pose->velocity_mm_per_s[i]);
  }
  for (i = 0; i < 4; i++) {
    put16(report + 20 + 2 * i, (uint16_t)pose->quaternion[i]);
  }
  put16(report + 34, pose->buttons);
  put16(report + 36, (uint16_t)pose->gripper_10um);
  put16(report + 38, device->out_sequence);
  report[40] = pose->fault;
  report[41] = pose->motor_heat;
  put16(report + 42, device->watchdog_trips);
  put32(report + 44, device->echoed_us);
}

void palpate_device_feature(const palpate_device* device,
                            uint8_t report[PALPATE_CAPABILITIES_BYTES]) {
  const palpate_capabilities* can = &device->capabilities;
  memset(report, 0, PALPATE_CAPABILITIES_BYTES);
  report[0] = PALPATE_CAPABILITIES_ID;
  report[1] = PALPATE_VERSION;
  memcpy(report + 2, "PLPT", 4);
  put16(report + 6, can->max_force_mn);
  put16(report + 8, can->continuous_force_mn);
  put16(report + 10, can->max_stiffness_n_per_m);
  put16(report + 12, can->max_torque_tenth_mnm);
  put16(report + 14, can->workspace_radius_tenth_mm);
  put16(report + 16, can->report_interval_us);
  put16(report + 18, can->watchdog_ms);
  report[20] = can->buttons;
  report[21] = can->dof_in;
  report[22] = can->dof_out;
  report[25] = can->flags;
}

static int host_is_silent(palpate_device* device, uint32_t now_us) {
  const uint32_t silent_us = now_us - device->heard_us; /* correct also when the clock wraps */
  if (!device->listening) {
    return 1;
  }
  if (silent_us >= (uint32_t)device->capabilities.watchdog_ms * 1000) {
    device->listening = 0;
    device->zeroed = 1;
    device->watchdog_trips++;
    return 1;
  }
  device->zeroed = 0;
  return 0;
}

void palpate_device_motors(palpate_device* device, uint32_t now_us, palpate_motors* motors) {
  const palpate_capabilities* can = &device->capabilities;
  int axis;
  memset(motors, 0, sizeof *motors);
  if (host_is_silent(device, now_us) || !device->force_on || device->hand_away) {
    return;
  }
  for (axis = 0; axis < 3; axis++) {
    motors->force_mn[axis] = clamp(device->wanted.force_mn[axis], can->max_force_mn);
    motors->torque_tenth_mnm[axis] =
        clamp(device->wanted.torque_tenth_mnm[axis], can->max_torque_tenth_mnm);
  }
  motors->gripper_mn = clamp(device->wanted.gripper_mn, can->max_force_mn);
}
