// The guarded frame of the C++ port. Follows GuardedSolver, ProxyVoxel, NeighbourhoodCache,
// FailedStepCache and PathLimit step by step, under the same names. Spacing 1, one cube.
#pragma once
#include <cstring>

#include "rays.h"

namespace {

constexpr double kStopShort = 0x1p-20;
constexpr double kCutShort = 1 - 0x1p-40;
constexpr double kFarVoxels = 8;
constexpr int kMaxStepUpsIfFar = 3;
constexpr double kMaxRow = 16;
constexpr int kLegs = 256;

double square(const Vec& a, const Vec& b) {
  double x = b.c[0] - a.c[0], y = b.c[1] - a.c[1], z = b.c[2] - a.c[2];
  return x * x + y * y + z * z;
}

constexpr int kSteps[3] = {1, 4, 16};
constexpr int kCentre = 21;

struct Guarded {
  const Cube& cube;
  double maxStep;
  Vec p{}, device{}, target{}, end{}, restedAt{};
  Hit hit{};
  int cell[3]{};
  uint64_t neighbours_ = 0;
  bool knowsNeighbours = false, stopped = false, outOfPath = false, rests = false,
       pathTooShort = false;
  bool skippedSearch = false, contact = false;
  int legCount = 0;
  int steps = 0;
  double legLength = 0;
  Vec legFrom[kLegs], legTo[kLegs];
  double legLengths[kLegs];
  bool legSlid[kLegs];
  int keptFrom[16][3];
  uint64_t kept[16];
  // failed steps
  bool known = false;
  int endCount = 0, reachedAxes = 0, endSides[24], stepCell[3], deviceSides = 0;
  Vec ends[24], stepDevice{};

  Guarded(const Cube& c, double step) : cube(c), maxStep(step) { reset(); }

  void reset() {
    rests = known = knowsNeighbours = false;
    for (int n = 0; n < 16; n++) keptFrom[n][0] = 1;  // an odd number, at which no window starts
  }

  void locate() {
    for (int a = 0; a < 3; a++) {
      int at = floorInt(p.c[a]);
      knowsNeighbours &= at == cell[a];
      cell[a] = at;
    }
  }

  uint64_t neighbours() {
    if (!knowsNeighbours) {
      knowsNeighbours = true;
      int from[3], shift = 0;
      for (int a = 0; a < 3; a++) {
        from[a] = (cell[a] - 1) & ~1;
        shift += ((cell[a] - 1) & 1) * kSteps[a];
      }
      int n = ((from[0] >> 1) + 5 * (from[1] >> 1) + 3 * (from[2] >> 1)) & 15;
      if (std::memcmp(keptFrom[n], from, sizeof from) != 0) {
        kept[n] = cube.window(from[0], from[1], from[2]);
        std::memcpy(keptFrom[n], from, sizeof from);
      }
      neighbours_ = kept[n] >> shift;
    }
    return neighbours_;
  }

  bool offPlanesExcept(int axis) const {
    return (axis == 0 || p.c[0] != cell[0]) && (axis == 1 || p.c[1] != cell[1]) &&
           (axis == 2 || p.c[2] != cell[2]);
  }
  bool contains(const Vec& to) const {
    for (int a = 0; a < 3; a++)
      if (!((to.c[a] > cell[a] && to.c[a] < cell[a] + 1.0) || to.c[a] == p.c[a])) return false;
    return true;
  }
  int face(int a, double to) {
    double from = p.c[a];
    if (to >= cell[a] + 1.0)
      return cell[a] + 1 - from <= kStopShort ? neighbours() >> (kCentre + kSteps[a]) & 1 : 0;
    return to <= cell[a] && to < from && from - cell[a] <= kStopShort
               ? neighbours() >> (kCentre - kSteps[a]) & 1
               : 0;
  }
  int facesThatStop(const Vec& to) {
    int faces = face(0, to.c[0]) | face(1, to.c[1]) << 1 | face(2, to.c[2]) << 2;
    if (faces == 0) return 0;
    int late = 0;
    double delta[3];
    for (int a = 0; a < 3; a++) delta[a] = std::fabs(to.c[a] - p.c[a]);
    for (int a = 0; a < 3; a++) {
      if (faces >> a & 1 || delta[a] == 0) continue;
      double gap = to.c[a] > p.c[a] ? cell[a] + 1 - p.c[a] : p.c[a] - cell[a];
      if (delta[a] < gap) continue;
      double least = 2 * kStopShort * delta[a];
      for (int b = 0; b < 3; b++) late |= (least >= gap * delta[b]) << b;
    }
    return faces & ~late;
  }
  int axisOfRow(const Vec& to) const {
    bool x = to.c[0] != p.c[0], y = to.c[1] != p.c[1], z = to.c[2] != p.c[2];
    if (x) return !y && !z && offPlanesExcept(0) ? 0 : -1;
    if (y) return !z && offPlanesExcept(1) ? 1 : -1;
    return offPlanesExcept(2) ? 2 : -1;
  }
  bool castRow(int a, double to) {
    double from = p.c[a];
    int step = to > from ? 1 : -1;
    int last = to > from ? floorInt(to) : static_cast<int>(std::ceil(to)) - 1;
    int at[3] = {cell[0], cell[1], cell[2]};
    while (at[a] != last) {
      at[a] += step;
      bool beside = at[a] == cell[a] + step;
      if (beside ? neighbours() >> (kCentre + step * kSteps[a]) & 1
                 : cube.solid(at[0], at[1], at[2])) {
        double plane = step > 0 ? at[a] : at[a] + 1;
        hit = {(plane - from) / (to - from), {at[0], at[1], at[2]}, a};
        return true;
      }
    }
    return false;
  }
  bool meetsSolid(const Vec& to) {
    int a = axisOfRow(to);
    if (a >= 0 && std::fabs(to.c[a] - p.c[a]) <= kMaxRow) return castRow(a, to.c[a]);
    return cast(cube, p, to, hit);
  }
  bool isFree(const Vec& to) { return contains(to) || !meetsSolid(to); }

  bool aim(int fixed) {
    for (int a = 0; a < 3; a++) target.c[a] = fixed >> a & 1 ? p.c[a] : device.c[a];
    return !(target == p);
  }
  bool cutToRemainingPath() {
    double left = maxStep - legLength;
    double sq = square(p, target);
    if (left > 0 && sq < left * left * kCutShort) return false;
    double length = std::sqrt(sq);
    if (length <= left) return false;
    double fraction = std::max(0.0, left / length * kCutShort);
    for (int a = 0; a < 3; a++) target.c[a] = p.c[a] + fraction * (target.c[a] - p.c[a]);
    if (std::sqrt(square(p, target)) > left) target = p;
    return true;
  }
  void move(const Vec& to, bool slid) {
    legFrom[legCount] = p;
    legTo[legCount] = to;
    legSlid[legCount] = slid;
    double length = std::sqrt(square(p, to));
    legLengths[legCount++] = length;
    legLength += length;
    p = to;
    locate();
    outOfPath |= legCount == kLegs;
  }
  bool moveNearer(const Vec& to, bool slid) {
    if (!(square(to, device) < square(p, device))) return false;
    move(to, slid);
    return true;
  }
  bool approach(bool slid) {
    int a = hit.axis;
    bool up = target.c[a] > p.c[a];
    double stopAt = up ? hit.cell[a] - kStopShort : hit.cell[a] + 1 + kStopShort;
    if (up ? stopAt <= p.c[a] : stopAt >= p.c[a]) return false;
    double fraction = (stopAt - p.c[a]) / (target.c[a] - p.c[a]);
    for (int b = 0; b < 3; b++) end.c[b] = p.c[b] + fraction * (target.c[b] - p.c[b]);
    end.c[a] = stopAt;
    if (axisOfRow(target) == a && std::fabs(target.c[a] - p.c[a]) <= kMaxRow)
      return moveNearer(end, slid);
    bool free = isFree(end);
    hit.axis = a;
    return free && moveNearer(end, slid);
  }
  bool slide(int fixedAxes) {
    bool moved = false;
    int fixed = fixedAxes;
    while (!outOfPath && aim(fixed)) {
      steps++;
      int faces = facesThatStop(target);
      if (faces != 0) {
        stopped = true;
        fixed |= faces;
        if (!aim(fixed)) return moved;
      }
      bool cut = cutToRemainingPath();
      if (!cut && !moved && contains(target)) {
        moveNearer(target, fixed != 0);
        return false;
      }
      double span = 0;
      for (int a = 0; a < 3; a++) span = std::max(span, std::fabs(target.c[a] - p.c[a]));
      steps += (int)(std::min(64.0, span) / 8);
      if (isFree(target)) {
        outOfPath |= cut;
        return moveNearer(target, fixed != 0) || moved;
      }
      stopped = true;
      moved |= approach(fixed != 0);
      fixed |= 1 << hit.axis;
    }
    return moved;
  }
  bool hasArrived() const { return p == device; }
  void slideUntilStuck(int fixedAxes) {
    bool on = true;
    while (on && !outOfPath && !hasArrived() && !(fixedAxes == 0 && isBudgetSpent()))
      on = slide(fixedAxes);
  }
  bool isBudgetSpent() const { return steps > 40 && legCount > 0; }
  bool isFar(double sq) const { return sq > kFarVoxels * kFarVoxels; }

  void addBestEnd(const Vec& e) {
    if (endCount < 24) {
      ends[endCount] = e;
      int s = 0;
      for (int a = 0; a < 3; a++)
        s |= (e.c[a] < stepDevice.c[a] ? 1 : e.c[a] > stepDevice.c[a] ? 8 : 0) << a;
      endSides[endCount] = s;
    }
    endCount++;
  }
  void addEnd(const Vec& e) {
    addBestEnd(e);
    for (int a = 0; a < 3; a++) reachedAxes |= (e.c[a] == stepDevice.c[a]) << a;
  }
  bool wouldFailAgain(int newSides, double sq) const {
    if (!known || deviceSides != newSides || std::memcmp(stepCell, cell, sizeof cell) != 0)
      return false;
    for (int a = 0; a < 3; a++)
      if (reachedAxes >> a & 1 && std::floor(device.c[a]) != std::floor(stepDevice.c[a]))
        return false;
    for (int n = 0; n < endCount; n++) {
      double left[3];
      for (int a = 0; a < 3; a++) {
        int s = endSides[n] >> a;
        double e = ends[n].c[a], at = device.c[a];
        left[a] = s & 1 ? std::max(0.0, at - e) : s & 8 ? std::max(0.0, e - at) : 0;
      }
      if (left[0] * left[0] + left[1] * left[1] + left[2] * left[2] < sq) return false;
    }
    return true;
  }
  bool stepUp() {
    double sq = square(p, device);
    int newSides = isFar(sq) ? 1 << 6 : 0;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      newSides |= (d > 0 ? 1 : d < 0 ? 2 : 0) << (2 * a);
    }
    if (wouldFailAgain(newSides, sq)) {
      skippedSearch = true;
      return false;
    }
    known = false;
    endCount = reachedAxes = 0;
    deviceSides = newSides;
    std::memcpy(stepCell, cell, sizeof cell);
    stepDevice = device;
    pathTooShort = false;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      if ((d <= 0 && stepUp(a, 1)) || (d >= 0 && stepUp(a, -1))) return true;
    }
    if (!pathTooShort) known = endCount <= 24;
    return false;
  }
  bool stepUp(int a, int direction) {
    double before = square(p, device);
    return findTop(a, direction, before) && stepUpTo(a, direction, before);
  }
  bool stepOpen(int axis, int direction) {
    int above = kCentre + direction * kSteps[axis];
    uint64_t bits = neighbours();
    if (bits >> above & 1) return false;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      if (a != axis && d != 0 && !(bits >> (d > 0 ? above + kSteps[a] : above - kSteps[a]) & 1))
        return true;
    }
    return false;
  }
  bool findTop(int a, int direction, double before) {
    steps++;
    if (!stepOpen(a, direction)) return false;
    double top = direction > 0 ? cell[a] + 1 + kStopShort : cell[a] - kStopShort;
    end = device;
    end.c[a] = top;
    if (square(end, device) >= before) {
      addBestEnd(end);
      return false;
    }
    end = p;
    end.c[a] = top;
    if (legLength + std::sqrt(square(p, end)) > maxStep) {
      pathTooShort = true;
      return false;
    }
    return offPlanesExcept(a) || isFree(end);
  }
  bool stepUpTo(int a, int direction, double before) {
    Vec beforeStep = p;
    int legsBefore = legCount;
    double pathBefore = legLength;
    int stepsLeft = isFar(before) ? kMaxStepUpsIfFar : 1;
    do {
      Vec top = end;
      move(top, true);
      slideUntilStuck(1 << a);
      if (square(p, device) < before) return true;
      addEnd(p);
      stepsLeft--;
    } while (stepsLeft > 0 && !outOfPath && findTop(a, direction, before));
    pathTooShort |= outOfPath;
    p = beforeStep;
    locate();
    legCount = legsBefore;
    legLength = pathBefore;
    outOfPath = false;
    return false;
  }
  void follow(const Vec& d) {
    legCount = 0;
    steps = 0;
    legLength = 0;
    bool same = std::memcmp(&d, &restedAt, sizeof d) == 0;
    if (rests && same) return;
    device = d;
    stopped = outOfPath = skippedSearch = false;
    locate();
    if (same) known = false;
    do slideUntilStuck(0);
    while (!outOfPath && !hasArrived() && !isBudgetSpent() && stepUp());
    contact = stopped || (!hasArrived() && !isFree(device));
    rests = legCount == 0 && !skippedSearch;
    restedAt = d;
  }
};

}  // namespace
