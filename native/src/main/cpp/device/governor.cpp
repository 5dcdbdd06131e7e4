#include "device/governor.h"

#include <algorithm>
#include <cmath>

#include "device/clock.h"

namespace palpate {
namespace {

bool isFinite(const double (&v)[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double length(const double (&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

double distance(const double (&a)[3], const double (&b)[3]) {
  const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return length(d);
}

void scaleInto(const double (&v)[3], double factor, double (&dest)[3]) {
  for (int axis = 0; axis < 3; axis++) {
    dest[axis] = v[axis] * factor;
  }
}

/** Returns the factor that scales a vector of this length to within the limit. */
double within(double length, double limit) { return length > limit ? limit / length : 1; }

}  // namespace

Governor::Governor(const Specification& specification)
    : nominalNewton_(specification.maxForceNewton),
      continuousNewton_(specification.continuousForceNewton > 0
                            ? std::min(specification.continuousForceNewton, nominalNewton_)
                            : nominalNewton_),
      nominalTorque_(specification.maxTorqueNewtonMetre),
      staleNanos_(std::max(kStaleNanos, 3 * specification.reportIntervalNanos)) {}

void Governor::sampled(bool fresh, const Sample& sample, int64_t nowNanos) {
  if (!fresh || !isFinite(sample.positionMm)) {
    return;
  }
  if (stale_ || nowNanos - freshNanos_ > staleNanos_) {
    returnOver(kReturnNanos, nowNanos);
  }
  stale_ = false;
  freshNanos_ = nowNanos;
  if ((sample.flags & kForceReady) == 0) {
    waiting_ = true;
    anchored_ = false;
  } else if (waiting_) {
    followHand(sample, nowNanos);
  }
}

void Governor::followHand(const Sample& sample, int64_t nowNanos) {
  if (!anchored_ || distance(sample.positionMm, anchorMm_) > kStillMm) {
    std::copy(std::begin(sample.positionMm), std::end(sample.positionMm), anchorMm_);
    anchoredNanos_ = nowNanos;
    anchored_ = true;
  } else if (nowNanos - anchoredNanos_ >= kStillNanos) {
    waiting_ = false;
    returnOver(kSoftStartNanos, nowNanos);
  }
}

void Governor::returnOver(int64_t rampNanos, int64_t nowNanos) {
  rampFromNanos_ = nowNanos;
  rampNanos_ = rampNanos;
}

double Governor::share(int64_t nowNanos) {
  if (nowNanos - freshNanos_ > staleNanos_) {
    stale_ = true;
  }
  if (waiting_ || stale_) {
    return 0;
  }
  const double along =
      static_cast<double>(nowNanos - rampFromNanos_) / static_cast<double>(rampNanos_);
  return std::clamp(along, 0.0, 1.0);
}

double Governor::heatLimitNewton() const {
  const double full = continuousNewton_ * continuousNewton_;
  // From 80 % of the continuous limit on, the maximum falls gradually, so that it does not chatter.
  const double over = std::clamp((heatNewton2_ - 0.8 * full) / (0.2 * full), 0.0, 1.0);
  return nominalNewton_ + (continuousNewton_ - nominalNewton_) * over;
}

void Governor::slew(double seconds, double (&force)[3]) {
  const double most = nominalNewton_ * seconds / kFullSlewSeconds;
  const double step = distance(force, lastForce_);
  if (step > most) {
    for (int axis = 0; axis < 3; axis++) {
      force[axis] = lastForce_[axis] + (force[axis] - lastForce_[axis]) * (most / step);
    }
  }
}

void Governor::clampForce(const double (&wanted)[3], double share, double seconds,
                          double (&dest)[3]) {
  const double size = length(wanted);
  if (share == 0 || size == 0 || !isFinite(wanted)) {
    std::fill(std::begin(dest), std::end(dest), 0.0);  // the slew rate never delays zero
  } else {
    const double factor = std::isfinite(size) ? within(size, heatLimitNewton()) * share : 0;
    scaleInto(wanted, factor, dest);
    slew(seconds, dest);
  }
  std::copy(std::begin(dest), std::end(dest), lastForce_);
  const double felt = length(dest);
  heatNewton2_ += (felt * felt - heatNewton2_) * std::min(1.0, seconds / kHeatSeconds);
}

void Governor::limit(const Wrench& wanted, int64_t nowNanos, Wrench& dest) {
  const int64_t nanos = everLimited_ ? std::max<int64_t>(0, nowNanos - limitedNanos_) : 0;
  const double seconds = static_cast<double>(nanos) / static_cast<double>(kNanosPerSecond);
  everLimited_ = true;
  limitedNanos_ = nowNanos;
  const double now = share(nowNanos);
  clampForce(wanted.forceNewton, now, seconds, dest.forceNewton);
  const bool turns = isFinite(wanted.torqueNewtonMetre);
  const double turn = turns ? within(length(wanted.torqueNewtonMetre), nominalTorque_) * now : 0;
  for (int axis = 0; axis < 3; axis++) {
    dest.torqueNewtonMetre[axis] = turns ? wanted.torqueNewtonMetre[axis] * turn : 0;
  }
  dest.gripperNewton = std::isfinite(wanted.gripperNewton)
                           ? std::clamp(wanted.gripperNewton, -nominalNewton_, nominalNewton_) * now
                           : 0;
}

}  // namespace palpate
