/*
 * Device side of the Palpate HID protocol, version 1 (see ../hid-protocol.md).
 *
 * Plain C99, no allocation, no floating point, no clock of its own: it runs on a microcontroller as
 * on a PC. The three USB calls and palpate_device_motors must not interrupt one another; call them
 * from one priority, or mask interrupts around them.
 */
#ifndef PALPATE_DEVICE_H
#define PALPATE_DEVICE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PALPATE_IN_BYTES = 48,
  PALPATE_OUT_BYTES = 24,
  PALPATE_CAPABILITIES_BYTES = 32,
  PALPATE_IN_ID = 1,
  PALPATE_OUT_ID = 2,
  PALPATE_CAPABILITIES_ID = 3,
  PALPATE_VERSION = 1,
};

/* Byte 1 of an IN report. */
enum {
  PALPATE_CALIBRATED = 1 << 0,
  PALPATE_HAND_PRESENT = 1 << 1,
  PALPATE_FORCE_ON = 1 << 2,
  PALPATE_WATCHDOG_ZEROED = 1 << 3,
  PALPATE_MOTORS_HOT = 1 << 4,
};

/* Byte 1 of an OUT report. */
enum {
  PALPATE_WANT_FORCE = 1 << 0,
  PALPATE_ENDING = 1 << 1,
};

/* Byte 40 of an IN report; from 128 on the session ends. */
enum {
  PALPATE_FAULT_NONE = 0,
  PALPATE_FAULT_HOT = 1,
  PALPATE_FAULT_POWER = 2,
  PALPATE_FAULT_ENCODER = 128,
  PALPATE_FAULT_MOTOR = 129,
};

/* Byte 25 of the capabilities. */
enum {
  PALPATE_HAS_HAND_SENSOR = 1 << 0,
  PALPATE_HAS_GRIPPER = 1 << 1,
};

/* What the device can do; sent as feature report 3. */
typedef struct {
  uint16_t max_force_mn;
  uint16_t continuous_force_mn;
  uint16_t max_stiffness_n_per_m;
  uint16_t max_torque_tenth_mnm;
  uint16_t workspace_radius_tenth_mm;
  uint16_t report_interval_us;
  uint16_t watchdog_ms;
  uint8_t buttons;
  uint8_t dof_in;
  uint8_t dof_out;
  uint8_t flags;
} palpate_capabilities;

/* What the sensors say now. */
typedef struct {
  int32_t position_um[3];
  int16_t quaternion[4]; /* x, y, z, w times 32767 */
  int16_t velocity_mm_per_s[3];
  uint16_t buttons;
  int16_t gripper_10um;
  uint8_t calibrated;
  uint8_t hand_present;
  uint8_t fault;
  uint8_t motor_heat; /* 0 cold .. 255 as hot as they may be */
} palpate_pose;

/* What the motors are to do now. */
typedef struct {
  int16_t force_mn[3];
  int16_t torque_tenth_mnm[3];
  int16_t gripper_mn;
} palpate_motors;

typedef struct {
  palpate_capabilities capabilities;
  palpate_motors wanted;
  uint32_t heard_us;
  uint32_t echoed_us;
  uint16_t out_sequence;
  uint16_t in_sequence;
  uint16_t watchdog_trips;
  uint8_t listening;
  uint8_t force_on;
  uint8_t zeroed;
  uint8_t hand_away; /* the hand sensor says so, or has said nothing yet */
} palpate_device;

/* The HID report descriptor to hand to the USB stack. */
extern const uint8_t palpate_report_descriptor[];
extern const size_t palpate_report_descriptor_bytes;

void palpate_device_init(palpate_device* device, const palpate_capabilities* capabilities);

/* Takes an OUT report as it came, id first. Returns 0 where it is not one of ours. */
int palpate_device_out(palpate_device* device, const uint8_t* report, size_t length,
                       uint32_t now_us);

/* Writes the next IN report; call once a report interval. */
void palpate_device_in(palpate_device* device, const palpate_pose* pose, uint32_t now_us,
                       uint8_t report[PALPATE_IN_BYTES]);

/* Writes the capabilities as feature report 3. */
void palpate_device_feature(const palpate_device* device,
                            uint8_t report[PALPATE_CAPABILITIES_BYTES]);

/*
 * What the motors are to do now: the force last heard, within the maximum; zero where the host has
 * been silent for watchdog_ms, and where the hand sensor of the last IN report was let go. Call
 * from the motor loop, at least once a millisecond.
 */
void palpate_device_motors(palpate_device* device, uint32_t now_us, palpate_motors* motors);

#ifdef __cplusplus
}
#endif

#endif
