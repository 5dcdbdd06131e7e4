#include "device/governor.h"

#include <cmath>
#include <random>

#include "check.h"
#include "device/clock.h"

using palpate::Governor;
using palpate::kNanosPerMilli;
using palpate::Sample;
using palpate::Specification;
using palpate::Wrench;

namespace {

Specification omni() {
  Specification specification;
  specification.maxForceNewton = 3.3;
  specification.continuousForceNewton = 0.9;
  specification.reportIntervalNanos = kNanosPerMilli;
  return specification;
}

Wrench along(double x, double y = 0, double z = 0) {
  Wrench wrench;
  wrench.forceNewton[0] = x;
  wrench.forceNewton[1] = y;
  wrench.forceNewton[2] = z;
  return wrench;
}

double size(const Wrench& wrench) {
  const double* f = wrench.forceNewton;
  return std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
}

/** A governor and a hand, with frames of one millisecond. */
struct Hand {
  Governor governor{omni()};
  Sample sample;
  Wrench felt;
  int64_t nowNanos = 1000 * kNanosPerMilli;

  double frame(const Wrench& wanted, bool fresh = true) {
    nowNanos += kNanosPerMilli;
    governor.sampled(fresh, sample, nowNanos);
    governor.limit(wanted, nowNanos, felt);
    return size(felt);
  }

  void settle() {
    for (int i = 0; i < 800; i++) {
      frame(Wrench());
    }
  }
};

}  // namespace

TEST("no force before the hand has held the device still, then it comes slowly") {
  Hand hand;
  for (int i = 0; i < 1000; i++) {
    hand.sample.positionMm[0] = i;  // one metre per second
    CHECK_EQUAL(0.0, hand.frame(along(1)));
  }
  CHECK(hand.governor.isWaitingForHand());
  double last = 0;
  double most = 0;
  for (int i = 0; i < 750; i++) {
    const double now = hand.frame(along(1));
    CHECK(i > 198 || now == 0);
    CHECK(now >= last - 1e-12);
    most = std::max(most, now - last);
    last = now;
  }
  CHECK_EQUAL(1.0, last);
  CHECK(most <= 1.0 / 499);
}

TEST("whatever is asked for, what is felt is finite and within the nominal maximum") {
  Hand hand;
  hand.settle();
  std::mt19937_64 random(20130207);
  std::uniform_real_distribution<double> exponent(-300, 308);
  const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 0.0, -0.0, 5e-324};
  for (int i = 0; i < 20000; i++) {
    Wrench wanted;
    for (double& component : wanted.forceNewton) {
      component = random() % 4 == 0 ? odd[random() % 8] : std::pow(10, exponent(random));
    }
    const double felt = hand.frame(wanted);
    CHECK_THAT(felt <= 3.3 * (1 + 1e-12), "frame " + std::to_string(i));
  }
}

TEST("a force held for long comes down to what the motors bear for ever") {
  Hand hand;
  hand.settle();
  double first = 0;
  double square = 0;
  for (int i = 0; i < 60000; i++) {
    const double felt = hand.frame(along(10));
    first = i == 20 ? felt : first;
    square += i >= 30000 ? felt * felt / 30000 : 0;
  }
  CHECK_NEAR(3.3, first, 1e-9);
  CHECK(std::sqrt(square) <= 0.9 * 1.0001);
  CHECK(std::sqrt(square) > 0.75);
}

TEST("a force never steps faster than from nothing to all in five milliseconds") {
  Hand hand;
  hand.settle();
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 2);
  Wrench before;
  for (int i = 0; i < 5000; i++) {
    hand.frame(along(normal(random), normal(random), normal(random)));
    double step = 0;
    for (int axis = 0; axis < 3; axis++) {
      step = std::hypot(step, hand.felt.forceNewton[axis] - before.forceNewton[axis]);
    }
    CHECK(step <= 3.3 / 5 * (1 + 1e-9));
    before = hand.felt;
  }
}

TEST("zero is never held back") {
  Hand hand;
  hand.settle();
  for (int i = 0; i < 20; i++) {
    hand.frame(along(3));
  }
  CHECK_NEAR(3.0, size(hand.felt), 1e-9);
  CHECK_EQUAL(0.0, hand.frame(along(0)));
}

TEST("without samples the force is zero after 20 ms and comes back slowly") {
  Hand hand;
  hand.settle();
  for (int i = 0; i < 20; i++) {
    hand.frame(along(1));
  }
  for (int i = 1; i <= 40; i++) {
    const double felt = hand.frame(along(1), false);
    CHECK_THAT(i <= 20 ? felt == 1 : felt == 0, "after " + std::to_string(i) + " ms");
  }
  CHECK_EQUAL(0.0, hand.frame(along(1)));
  double last = 0;
  for (int i = 0; i < 100; i++) {
    const double now = hand.frame(along(1));
    CHECK(now > last && now - last < 0.011);
    last = now;
  }
  CHECK_EQUAL(1.0, last);
}

TEST("a position that is not finite counts as no sample") {
  Hand hand;
  hand.settle();
  hand.sample.positionMm[1] = NAN;
  for (int i = 0; i < 21; i++) {
    hand.frame(along(1));
  }
  CHECK_EQUAL(0.0, hand.frame(along(1)));
}

TEST("a dead-man let go takes the force away and starts anew with a still hand") {
  Hand hand;
  hand.settle();
  hand.sample.flags = 0;
  CHECK_EQUAL(0.0, hand.frame(along(1)));
  hand.sample.flags = palpate::kForceReady;
  for (int i = 0; i < 200; i++) {
    CHECK_EQUAL(0.0, hand.frame(along(1)));
  }
  CHECK(hand.governor.isWaitingForHand());
}
