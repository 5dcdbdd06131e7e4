#include "virtual_device.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

namespace {

palpate_capabilities capabilities() {
  palpate_capabilities can = {};
  can.max_force_mn = 6000;
  can.continuous_force_mn = 3000;
  can.max_stiffness_n_per_m = 1500;
  can.workspace_radius_tenth_mm = 600;
  can.report_interval_us = 1000;
  can.watchdog_ms = 20;
  can.buttons = 2;
  can.dof_in = 3;
  can.dof_out = 3;
  return can;
}

pid_t run(char** command) {
  const pid_t child = fork();
  if (child == 0) {
    execvp(command[0], command);
    std::perror(command[0]);
    _exit(127);
  }
  return child;
}

}  // namespace

VirtualDevice::VirtualDevice() {
  const palpate_capabilities can = capabilities();
  palpate_device_init(&firmware_, &can);
}

int VirtualDevice::serve(const char* name, char** command) {
  const pid_t child = run(command);
  Felt felt;
  palpate_pose pose = {};
  pose.calibrated = 1;
  pose.hand_present = 1;
  pose.quaternion[3] = 32767;
  palpate_motors motors = {};
  const long start = nowNanos();
  uint32_t micros = 0;
  long openedMillis = -1;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    const long millis = nextMillisecond(start);
    micros += 1000;
    const int reports = receive(micros);
    openedMillis = reports > 0 && openedMillis < 0 ? millis : openedMillis;
    moveHand(pose, openedMillis < 0 ? 0 : static_cast<double>(millis - openedMillis) / 1000);
    uint8_t report[PALPATE_IN_BYTES];
    palpate_device_in(&firmware_, &pose, micros, report);
    send(report);
    palpate_device_motors(&firmware_, micros, &motors);
    if (openedMillis >= 0) {
      felt.note(motors, reports);
    }
  }
  micros += 1000;
  receive(micros);
  palpate_device_motors(&firmware_, micros, &motors);
  felt.say(name, firmware_, motors);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
}
