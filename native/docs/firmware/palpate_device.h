/*
 * Device side of the Palpate HID protocol, version 1 (see ../hid-protocol.md).
 *
 * Plain C99 without allocation, floating point or a clock of its own. It runs on a microcontroller
 * and on a PC. The three USB calls and palpate_device_motors must not interrupt one another. Call
 * them at one interrupt priority, or mask interrupts around them.
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

/* Byte 40 of an IN report. A code of 128 or more ends the session. */
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

/* The capabilities of the device, sent as feature report 3. */
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

/* The present readings of the sensors. */
typedef struct {
  int32_t position_um[3];
  int16_t quaternion[4]; /* x, y, z, w times 32767 */
  int16_t velocity_mm_per_s[3];
  uint16_t buttons;
  int16_t gripper_10um;
  uint8_t calibrated;
  uint8_t hand_present;
  uint8_t fault;
  uint8_t motor_heat; /* from 0, cold, to 255, the hottest allowed */
} palpate_pose;

/* The force, the torque and the gripper force that the motors exert now. */
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
  uint8_t hand_away; /* no hand on the sensor, or no reading yet */
} palpate_device;

/* The HID report descriptor to hand to the USB stack. */
extern const uint8_t palpate_report_descriptor[];
extern const size_t palpate_report_descriptor_bytes;

void palpate_device_init(palpate_device* device, const palpate_capabilities* capabilities);

/* Takes an OUT report as it was received, id first. Returns 0 if it is not of this protocol. */
int palpate_device_out(palpate_device* device, const uint8_t* report, size_t length,
                       uint32_t now_us);

/* Writes the next IN report. Call it once in each report interval. */
void palpate_device_in(palpate_device* device, const palpate_pose* pose, uint32_t now_us,
                       uint8_t report[PALPATE_IN_BYTES]);

/* Writes the capabilities as feature report 3. */
void palpate_device_feature(const palpate_device* device,
                            uint8_t report[PALPATE_CAPABILITIES_BYTES]);

/*
 * Writes the order for the motors: the last force received, limited to the maximum. It is zero if
 * the host has been silent for watchdog_ms, or if the last IN report had no hand on the sensor.
 * Call it from the motor loop at least once a millisecond.
 */
void palpate_device_motors(palpate_device* device, uint32_t now_us, palpate_motors* motors);

#ifdef __cplusplus
}
#endif

#endif
