#include "openhaptics/servo.h"

#include <cmath>

#include "device/clock.h"
#include "device/rotation.h"

namespace palpate::openhaptics {
namespace {

constexpr int64_t kTicksBetweenTemperatures = 100;
constexpr int kMostErrorsATick = 8;

/** Whether an error concerns a single force and not the device. */
bool isPassing(Error error) { return error >= kWarmMotors && error <= kExceededLast; }

/**
 * Fills in the pose from the vendor's transform: column-major, the translation in 12 to 14, mm. The
 * vendor's frame is ours.
 */
void fillPose(const double (&transform)[16], Sample& sample) {
  double rotation[3][3];
  for (int row = 0; row < 3; row++) {
    sample.positionMm[row] = transform[12 + row];
    for (int column = 0; column < 3; column++) {
      rotation[row][column] = transform[4 * column + row];
    }
  }
  quaternionOf(rotation, sample.orientation);
}

}  // namespace

unsigned PALPATE_HD_CALL Servo::tick(void* servo) { return static_cast<Servo*>(servo)->run(); }

unsigned Servo::run() {
  const bool last = ending_.load();
  Reading reading;
  traced(trace_, "hdBeginFrame", api_.beginFrame, device_);
  readState(reading.sample);
  setForce(last ? Wrench() : newestOrder(steadyNanos()));
  traced(trace_, "hdEndFrame", api_.endFrame, device_);
  drainErrors(reading);
  reading.tick = ++ticks_;
  reading.failures = failures_;
  readings_.publish(reading);
  const bool done = last && reading.error == kSuccess;
  if (done) {
    zeroSent_.store(true);  // from now on another thread may delete this
  }
  return done ? kCallbackDone : kCallbackContinue;
}

void Servo::sendZero() {
  Reading reading;
  traced(trace_, "hdBeginFrame", api_.beginFrame, device_);
  setForce(Wrench());
  traced(trace_, "hdEndFrame", api_.endFrame, device_);
  drainErrors(reading);
  zeroSent_.store(reading.error == kSuccess);
}

void Servo::readState(Sample& sample) {
  double transform[16] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN,
                          NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
  int buttons = 0;
  unsigned char held = 0;
  traced(trace_, "hdGetDoublev", api_.getDoublev, kCurrentTransform, transform);
  traced(trace_, "hdGetIntegerv", api_.getIntegerv, kCurrentButtons, &buttons);
  traced(trace_, "hdGetBooleanv", api_.getBooleanv, kSafetySwitch, &held);
  if (ticks_ % kTicksBetweenTemperatures == 0) {
    double motors[6] = {0, 0, 0, 0, 0, 0};
    traced(trace_, "hdGetDoublev", api_.getDoublev, kMotorTemperature, motors);
    heat_ = 0;
    for (const double motor : motors) {
      heat_ = motor > heat_ ? motor : heat_;
    }
  }
  fillPose(transform, sample);
  sample.timeNanos = steadyNanos();
  sample.buttons = static_cast<uint32_t>(buttons);
  sample.motorHeat = heat_;
  // A device without a safety switch never reports a held one.
  hasSwitch_ = hasSwitch_ || held != 0;
  if (hasSwitch_ && held == 0) {
    sample.flags &= ~uint32_t{kForceReady};
  }
}

Wrench Servo::newestOrder(int64_t nowNanos) {
  if (orders_.take(current_)) {
    heardNanos_ = nowNanos;
  }
  return nowNanos - heardNanos_ > kSilenceNanos ? Wrench() : current_;
}

void Servo::setForce(const Wrench& wrench) {
  traced(trace_, "hdSetDoublev", api_.setDoublev, kCurrentForce, wrench.forceNewton);
  if (hasTorque_) {
    double milli[3];
    for (int axis = 0; axis < 3; axis++) {
      milli[axis] = wrench.torqueNewtonMetre[axis] * 1000;  // the library's torques are in mN m
    }
    traced(trace_, "hdSetDoublev", api_.setDoublev, kCurrentTorque, milli);
  }
}

/** Empties the library's stack of errors. The first error is the cause. */
void Servo::drainErrors(Reading& reading) {
  bool failed = false;
  for (int i = 0; i < kMostErrorsATick; i++) {
    const ErrorInfo info = traced(trace_, "hdGetError", api_.getError);
    if (info.code == kSuccess) {
      break;
    }
    reading.sample.flags |= info.code == kWarmMotors ? uint32_t{kMotorsHot} : 0;
    if (!isPassing(info.code)) {
      reading.error = failed ? reading.error : info.code;
      failed = true;
    }
  }
  failures_ += failed ? 1 : 0;
  failuresInARow_ = failed ? failuresInARow_ + 1 : 0;
  reading.fatal = failuresInARow_ >= kMostFailures;
}

}  // namespace palpate::openhaptics
