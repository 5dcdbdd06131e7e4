// The C++ twin of the guarded frame and the exact ray cast, over the same bricks: what the machine can
// do. Follows the Java classes GuardedSolver, PointVoxel, Neighbourhoods, FruitlessClimbs, NearRayWalk
// and FarRayWalk step by step, so that every double is the same (no fused multiply-add). Where a ray is
// in doubt it counts that and calls it a miss: Java asks its thorough walk there, the twin has none.
//
//   twin INPUT PASSES    INPUT as CppTwin writes it; one line: hash, doubts, nanoseconds of each pass
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>
#include <ctime>

namespace {

constexpr double kStopShort = 0x1p-20;
constexpr double kCutShort = 1 - 0x1p-40;
constexpr double kFarVoxels = 8;
constexpr int kStairsIfFar = 3;
constexpr double kLongestRow = 16;
constexpr double kNearVoxels = 10;
constexpr int kLegs = 256;
enum Answer { kMiss, kHit, kDoubt };

struct Vec {
  double c[3];
  bool operator==(const Vec& o) const { return c[0] == o.c[0] && c[1] == o.c[1] && c[2] == o.c[2]; }
};

struct Hit {
  double t;
  int cell[3];
  int axis;
};

int floorInt(double v) { return static_cast<int>(std::floor(v)); }
double doubtOf(double t) { return t * 0x1p-48 + 0x1p-1000; }
int bitOf(int i, int j, int k) { return (k & 3) << 4 | (j & 3) << 2 | (i & 3); }

struct Cube {
  int size[3], bricksX, bricksY, bricksZ, blocksX, blocksY, blocksZ;
  int low[3], high[3];
  std::vector<uint64_t> bricks, blocks;

  uint64_t brick(int x, int y, int z) const {
    bool inside = static_cast<unsigned>(x) < static_cast<unsigned>(bricksX) &&
                  static_cast<unsigned>(y) < static_cast<unsigned>(bricksY) &&
                  static_cast<unsigned>(z) < static_cast<unsigned>(bricksZ);
    return inside ? bricks[(static_cast<size_t>(z) * bricksY + y) * bricksX + x] : 0;
  }
  uint64_t block(int x, int y, int z) const {
    bool inside = static_cast<unsigned>(x) < static_cast<unsigned>(blocksX) &&
                  static_cast<unsigned>(y) < static_cast<unsigned>(blocksY) &&
                  static_cast<unsigned>(z) < static_cast<unsigned>(blocksZ);
    return inside ? blocks[(static_cast<size_t>(z) * blocksY + y) * blocksX + x] : 0;
  }
  bool solid(int i, int j, int k) const {
    return brick(i >> 2, j >> 2, k >> 2) >> bitOf(i, j, k) & 1;
  }
  uint64_t row(int i, int y, int z) const {
    int shift = i & 3;
    uint64_t kept = static_cast<uint64_t>(0xf >> shift) * 0x1111111111111111u;
    return (brick(i >> 2, y, z) >> shift & kept) | (brick((i >> 2) + 1, y, z) << (4 - shift) & ~kept);
  }
  uint64_t slab(int i, int j, int z) const {
    int shift = (j & 3) << 2;
    uint64_t kept = static_cast<uint64_t>(0xffff >> shift) * 0x0001000100010001u;
    return (row(i, j >> 2, z) >> shift & kept) | (row(i, (j >> 2) + 1, z) << (16 - shift) & ~kept);
  }
  uint64_t window(int i, int j, int k) const {
    int shift = (k & 3) << 4;
    return slab(i, j, k >> 2) >> shift | slab(i, j, (k >> 2) + 1) << (48 - shift) << 16;
  }
};

uint64_t layersX(int a, int b) {
  return static_cast<uint64_t>((2 << std::max(a, b)) - (1 << std::min(a, b))) * 0x1111111111111111u;
}
uint64_t layersY(int a, int b) {
  return static_cast<uint64_t>((16 << (std::max(a, b) << 2)) - (1 << (std::min(a, b) << 2))) *
         0x0001000100010001u;
}
uint64_t layersZ(int a, int b) {
  return ~0ull >> ((3 - std::max(a, b)) << 4) & ~0ull << (std::min(a, b) << 4);
}
double median(double a, double b, double c) {
  double low = a < b ? a : b, high = a < b ? b : a;
  return c < low ? low : c < high ? c : high;
}
bool inDoubt(double t, double next) {
  double doubt = doubtOf(t);
  return next - t <= doubt || t + doubt >= 1;
}

Answer nearWalk(const Cube& cube, const Vec& from, const Vec& to, Hit& hit) {
  int cell[3], last[3];
  for (int a = 0; a < 3; a++) {
    cell[a] = floorInt(from.c[a]);
    last[a] = floorInt(to.c[a]);
    if (cell[a] == from.c[a]) return kDoubt;
  }
  uint64_t brick = cube.brick(cell[0] >> 2, cell[1] >> 2, cell[2] >> 2);
  if (brick >> bitOf(cell[0], cell[1], cell[2]) & 1) {
    hit = {0, {cell[0], cell[1], cell[2]}, -1};
    return kHit;
  }
  if (((cell[0] ^ last[0]) | (cell[1] ^ last[1]) | (cell[2] ^ last[2])) >> 2 == 0 &&
      last[0] != to.c[0] && last[1] != to.c[1] && last[2] != to.c[2] &&
      (brick & layersX(cell[0] & 3, last[0] & 3) & layersY(cell[1] & 3, last[1] & 3) &
       layersZ(cell[2] & 3, last[2] & 3)) == 0)
    return kMiss;
  double inverse[3], next[3];
  int ahead[3];
  for (int a = 0; a < 3; a++) {
    inverse[a] = 1 / (to.c[a] - from.c[a]);
    ahead[a] = inverse[a] < 0 ? 0 : 1;
    next[a] = (cell[a] + ahead[a] - from.c[a]) * inverse[a];
  }
  while (true) {
    int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    double t = next[axis];
    if (t > 1 + doubtOf(t)) return kMiss;
    if (inDoubt(t, median(next[0], next[1], next[2]))) return kDoubt;
    int before = cell[axis];
    cell[axis] += 2 * ahead[axis] - 1;
    next[axis] = (cell[axis] + ahead[axis] - from.c[axis]) * inverse[axis];
    if ((before ^ cell[axis]) >> 2 != 0) brick = cube.brick(cell[0] >> 2, cell[1] >> 2, cell[2] >> 2);
    if (brick >> bitOf(cell[0], cell[1], cell[2]) & 1) {
      hit = {t, {cell[0], cell[1], cell[2]}, axis};
      return kHit;
    }
  }
}

bool nearPlane(double v, int cell) { return v - cell < 0x1p-24 || v - cell > 1 - 0x1p-24; }

Answer farWalk(const Cube& cube, const Vec& from, const Vec& to, Hit& hit) {
  double inverse[3], entry[3];
  double start = -std::numeric_limits<double>::infinity(), end = -start;
  int ahead[3], cell[3];
  double at[3];
  for (int a = 0; a < 3; a++) {
    if (from.c[a] == std::rint(from.c[a])) return kDoubt;
    inverse[a] = 1 / (to.c[a] - from.c[a]);
    ahead[a] = inverse[a] < 0 ? 0 : 1;
    entry[a] = ((inverse[a] > 0 ? cube.low[a] : cube.high[a] + 1) - from.c[a]) * inverse[a];
    double exit = ((inverse[a] > 0 ? cube.high[a] + 1 : cube.low[a]) - from.c[a]) * inverse[a];
    start = std::max(start, entry[a]);
    end = std::min(end, exit);
  }
  end = std::min(1.0, end + doubtOf(end));
  if (start - doubtOf(start) > end) return kMiss;
  int axis = start <= 0 ? -1 : start == entry[0] ? 0 : start == entry[1] ? 1 : 2;
  double t = std::max(0.0, start);
  for (int a = 0; a < 3; a++) {
    at[a] = from.c[a] + t * (to.c[a] - from.c[a]);
    cell[a] = a == axis ? static_cast<int>(std::rint(at[a])) + ahead[a] - 1 : floorInt(at[a]);
  }
  int shift = axis < 0 ? 0 : 2;
  while (true) {
    if (shift != 0)
      for (int a = 0; a < 3; a++)
        if (a != axis && nearPlane(at[a], cell[a])) return kDoubt;
    uint64_t brick = cube.brick(cell[0] >> 2, cell[1] >> 2, cell[2] >> 2);
    if (brick >> bitOf(cell[0], cell[1], cell[2]) & 1) {
      hit = {t, {cell[0], cell[1], cell[2]}, axis};
      return kHit;
    }
    shift = brick != 0 ? 0 : cube.block(cell[0] >> 4, cell[1] >> 4, cell[2] >> 4) == 0 ? 4 : 2;
    int plane[3];
    double next[3];
    for (int a = 0; a < 3; a++) {
      plane[a] = ((cell[a] >> shift) + ahead[a]) * (1 << shift);
      next[a] = (plane[a] - from.c[a]) * inverse[a];
    }
    axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    t = next[axis];
    if (t > end && (end < 1 || t > 1 + doubtOf(t))) return kMiss;
    if (inDoubt(t, median(next[0], next[1], next[2]))) return kDoubt;
    if (shift != 0)
      for (int a = 0; a < 3; a++) {
        at[a] = from.c[a] + t * (to.c[a] - from.c[a]);
        cell[a] = floorInt(at[a]);
      }
    cell[axis] = plane[axis] + ahead[axis] - 1;
  }
}

int64_t doubts = 0;

bool cast(const Cube& cube, const Vec& from, const Vec& to, Hit& hit) {
  bool isNear = true;
  for (int a = 0; a < 3; a++) {
    if (std::max(from.c[a], to.c[a]) < cube.low[a] || std::min(from.c[a], to.c[a]) > cube.high[a] + 1.0)
      return false;
    isNear = isNear && std::fabs(to.c[a] - from.c[a]) <= kNearVoxels;
  }
  Answer answer = isNear ? nearWalk(cube, from, to, hit) : farWalk(cube, from, to, hit);
  doubts += answer == kDoubt;
  return answer == kHit;
}

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
  uint64_t near_ = 0;
  bool knowsNear = false, stopped = false, outOfPath = false, rests = false, pathTooShort = false;
  bool skippedClimbs = false, contact = false;
  int legCount = 0;
  double legLength = 0;
  Vec legFrom[kLegs], legTo[kLegs];
  double legLengths[kLegs];
  bool legSlid[kLegs];
  int keptCell[16][3];
  uint64_t kept[16];
  // fruitless climbs
  bool known = false;
  int endCount = 0, endStops[24], fromCell[3], way = 0;
  Vec ends[24], climbDevice{};

  Guarded(const Cube& c, double step) : cube(c), maxStep(step) { reset(); }

  void reset() {
    rests = known = false;
    for (int n = 0; n < 16; n++) {
      keptCell[n][0] = std::numeric_limits<int>::min();
      kept[n] = 0;
    }
  }

  void locate() {
    for (int a = 0; a < 3; a++) cell[a] = floorInt(p.c[a]);
    knowsNear = false;
  }

  uint64_t solidNear() {
    if (!knowsNear) {
      knowsNear = true;
      int n = (cell[0] + 5 * cell[1] + 3 * cell[2]) & 15;
      if (std::memcmp(keptCell[n], cell, sizeof cell) != 0) {
        kept[n] = cube.window(cell[0] - 1, cell[1] - 1, cell[2] - 1);
        std::memcpy(keptCell[n], cell, sizeof cell);
      }
      near_ = kept[n];
    }
    return near_;
  }

  bool insideBut(int axis) const {
    return (axis == 0 || p.c[0] != cell[0]) && (axis == 1 || p.c[1] != cell[1]) &&
           (axis == 2 || p.c[2] != cell[2]);
  }
  bool contains(const Vec& to) const {
    for (int a = 0; a < 3; a++)
      if (!((to.c[a] > cell[a] && to.c[a] < cell[a] + 1.0) || to.c[a] == p.c[a])) return false;
    return true;
  }
  int stop(int a, double to) {
    double from = p.c[a];
    if (to >= cell[a] + 1.0)
      return cell[a] + 1 - from <= kStopShort ? solidNear() >> (kCentre + kSteps[a]) & 1 : 0;
    return to <= cell[a] && to < from && from - cell[a] <= kStopShort
               ? solidNear() >> (kCentre - kSteps[a]) & 1
               : 0;
  }
  int stopsOnWayTo(const Vec& to) {
    int stops = stop(0, to.c[0]) | stop(1, to.c[1]) << 1 | stop(2, to.c[2]) << 2;
    if (stops == 0) return 0;
    int late = 0;
    double delta[3];
    for (int a = 0; a < 3; a++) delta[a] = std::fabs(to.c[a] - p.c[a]);
    for (int a = 0; a < 3; a++) {
      if (stops >> a & 1 || delta[a] == 0) continue;
      double gap = to.c[a] > p.c[a] ? cell[a] + 1 - p.c[a] : p.c[a] - cell[a];
      double least = 2 * kStopShort * delta[a];
      for (int b = 0; b < 3; b++) late |= (least >= gap * delta[b]) << b;
    }
    return stops & ~late;
  }
  int axisOfWay(const Vec& to) const {
    bool x = to.c[0] != p.c[0], y = to.c[1] != p.c[1], z = to.c[2] != p.c[2];
    if (x) return !y && !z && insideBut(0) ? 0 : -1;
    if (y) return !z && insideBut(1) ? 1 : -1;
    return insideBut(2) ? 2 : -1;
  }
  bool meetsAlong(int a, double to) {
    double from = p.c[a];
    int step = to > from ? 1 : -1;
    int last = to > from ? floorInt(to) : static_cast<int>(std::ceil(to)) - 1;
    if (cell[a] == last) return false;
    if (cell[a] + step == last && !(solidNear() >> (kCentre + step * kSteps[a]) & 1)) return false;
    int at[3] = {cell[0], cell[1], cell[2]};
    do {
      at[a] += step;
      if (cube.solid(at[0], at[1], at[2])) {
        double plane = step > 0 ? at[a] : at[a] + 1;
        hit = {(plane - from) / (to - from), {at[0], at[1], at[2]}, a};
        return true;
      }
    } while (at[a] != last);
    return false;
  }
  bool meetsSolid(const Vec& to) {
    int a = axisOfWay(to);
    if (a >= 0 && std::fabs(to.c[a] - p.c[a]) <= kLongestRow) return meetsAlong(a, to.c[a]);
    return cast(cube, p, to, hit);
  }
  bool isFree(const Vec& to) { return contains(to) || !meetsSolid(to); }

  bool aim(int faces) {
    for (int a = 0; a < 3; a++) target.c[a] = faces >> a & 1 ? p.c[a] : device.c[a];
    return !(target == p);
  }
  bool cutToPathLeft() {
    double left = maxStep - legLength;
    double sq = square(p, target);
    if (left > 0 && sq < left * left * kCutShort) return false;
    double length = std::sqrt(sq);
    if (length <= left) return false;
    double share = std::max(0.0, left / length * kCutShort);
    for (int a = 0; a < 3; a++) target.c[a] = p.c[a] + share * (target.c[a] - p.c[a]);
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
    double share = (stopAt - p.c[a]) / (target.c[a] - p.c[a]);
    for (int b = 0; b < 3; b++) end.c[b] = p.c[b] + share * (target.c[b] - p.c[b]);
    end.c[a] = stopAt;
    bool free = isFree(end);
    hit.axis = a;
    return free && moveNearer(end, slid);
  }
  bool slide(int held) {
    bool moved = false;
    int faces = held;
    while (!outOfPath && aim(faces)) {
      int stops = stopsOnWayTo(target);
      if (stops != 0) {
        stopped = true;
        faces |= stops;
        if (!aim(faces)) return moved;
      }
      bool cut = cutToPathLeft();
      if (!cut && !moved && contains(target)) {
        moveNearer(target, faces != 0);
        return false;
      }
      if (isFree(target)) {
        outOfPath |= cut;
        return moveNearer(target, faces != 0) || moved;
      }
      stopped = true;
      moved |= approach(faces != 0);
      faces |= 1 << hit.axis;
    }
    return moved;
  }
  bool arrived() const { return p == device; }
  void descend(int held) {
    bool on = true;
    while (on && !outOfPath && !arrived()) on = slide(held);
  }
  bool isFar(double sq) const { return sq > kFarVoxels * kFarVoxels; }

  void addEnd(const Vec& e) {
    if (endCount < 24) {
      ends[endCount] = e;
      int s = 0;
      for (int a = 0; a < 3; a++)
        s |= (e.c[a] < climbDevice.c[a] ? 1 : e.c[a] > climbDevice.c[a] ? 8 : 0) << a;
      endStops[endCount] = s;
    }
    endCount++;
  }
  bool holds(int newWay, double sq) const {
    if (!known || way != newWay || std::memcmp(fromCell, cell, sizeof cell) != 0) return false;
    for (int a = 0; a < 3; a++)
      if (std::floor(device.c[a]) != std::floor(climbDevice.c[a])) return false;
    for (int n = 0; n < endCount; n++) {
      double left[3];
      for (int a = 0; a < 3; a++) {
        int s = endStops[n] >> a;
        double e = ends[n].c[a], at = device.c[a];
        left[a] = s & 1 ? std::max(0.0, at - e) : s & 8 ? std::max(0.0, e - at) : 0;
      }
      if (left[0] * left[0] + left[1] * left[1] + left[2] * left[2] < sq) return false;
    }
    return true;
  }
  bool climb() {
    double sq = square(p, device);
    int newWay = isFar(sq) ? 1 << 6 : 0;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      newWay |= (d > 0 ? 1 : d < 0 ? 2 : 0) << (2 * a);
    }
    if (holds(newWay, sq)) {
      skippedClimbs = true;
      return false;
    }
    known = false;
    endCount = 0;
    way = newWay;
    std::memcpy(fromCell, cell, sizeof cell);
    climbDevice = device;
    pathTooShort = false;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      if ((d <= 0 && climb(a, 1)) || (d >= 0 && climb(a, -1))) return true;
    }
    if (!pathTooShort) known = endCount <= 24;
    return false;
  }
  bool climb(int a, int direction) {
    double before = square(p, device);
    return aimAtStair(a, direction, before) && climbTo(a, direction, before);
  }
  bool stairOpen(int axis, int direction) {
    int above = kCentre + direction * kSteps[axis];
    uint64_t bits = solidNear();
    if (bits >> above & 1) return false;
    for (int a = 0; a < 3; a++) {
      double d = device.c[a] - p.c[a];
      if (a != axis && d != 0 && !(bits >> (d > 0 ? above + kSteps[a] : above - kSteps[a]) & 1)) return true;
    }
    return false;
  }
  bool aimAtStair(int a, int direction, double before) {
    if (!stairOpen(a, direction)) return false;
    double top = direction > 0 ? cell[a] + 1 + kStopShort : cell[a] - kStopShort;
    end = device;
    end.c[a] = top;
    if (square(end, device) >= before) {
      addEnd(end);
      return false;
    }
    end = p;
    end.c[a] = top;
    if (legLength + std::sqrt(square(p, end)) > maxStep) {
      pathTooShort = true;
      return false;
    }
    return insideBut(a) || isFree(end);
  }
  bool climbTo(int a, int direction, double before) {
    Vec beforeClimb = p;
    int legsBefore = legCount;
    double pathBefore = legLength;
    int stairs = isFar(before) ? kStairsIfFar : 1;
    do {
      Vec top = end;
      move(top, true);
      descend(1 << a);
      if (square(p, device) < before) return true;
      addEnd(p);
      stairs--;
    } while (stairs > 0 && !outOfPath && aimAtStair(a, direction, before));
    pathTooShort |= outOfPath;
    p = beforeClimb;
    locate();
    legCount = legsBefore;
    legLength = pathBefore;
    outOfPath = false;
    return false;
  }
  void follow(const Vec& d) {
    legCount = 0;
    legLength = 0;
    bool same = std::memcmp(&d, &restedAt, sizeof d) == 0;
    if (rests && same) return;
    device = d;
    stopped = outOfPath = skippedClimbs = false;
    locate();
    if (same) known = false;
    do descend(0);
    while (!outOfPath && !arrived() && climb());
    contact = stopped || (!arrived() && !isFree(device));
    rests = legCount == 0 && !skippedClimbs;
    restedAt = d;
  }
};

template <typename T>
void read(FILE* file, T* dest, size_t count) {
  if (std::fread(dest, sizeof(T), count, file) != count) {
    std::fprintf(stderr, "twin: input is too short\n");
    std::exit(2);
  }
}

int64_t cpuNanos() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * 1000000000LL + now.tv_nsec;
}

uint64_t bits(double v) {
  uint64_t b;
  std::memcpy(&b, &v, sizeof b);
  return b;
}

}  // namespace

int main(int argc, char** argv) {
  FILE* file = argc == 3 ? std::fopen(argv[1], "rb") : nullptr;
  if (!file) {
    std::fprintf(stderr, "usage: twin INPUT PASSES\n");
    return 2;
  }
  Cube cube;
  int counts[6], frames;
  double maxStep;
  read(file, counts, 6);
  cube.bricksX = counts[0], cube.bricksY = counts[1], cube.bricksZ = counts[2];
  cube.blocksX = counts[3], cube.blocksY = counts[4], cube.blocksZ = counts[5];
  read(file, cube.low, 3);
  read(file, cube.high, 3);
  cube.bricks.resize(static_cast<size_t>(counts[0]) * counts[1] * counts[2]);
  cube.blocks.resize(static_cast<size_t>(counts[3]) * counts[4] * counts[5]);
  read(file, cube.bricks.data(), cube.bricks.size());
  read(file, cube.blocks.data(), cube.blocks.size());
  read(file, &frames, 1);
  read(file, &maxStep, 1);
  std::vector<Vec> way(frames);
  read(file, way.data(), way.size());
  std::fclose(file);
  Guarded* solver = new Guarded(cube, maxStep);
  std::vector<double> nanos;
  uint64_t hash = 0;
  for (int pass = 0; pass < std::atoi(argv[2]); pass++) {
    int64_t begin = cpuNanos();
    solver->reset();
    solver->p = way[0];
    hash = 0;
    for (const Vec& d : way) {
      solver->follow(d);
      hash = hash * 31 + bits(solver->p.c[0]) + 7 * bits(solver->p.c[1]) + 13 * bits(solver->p.c[2]) +
             solver->contact + 3 * static_cast<uint64_t>(solver->legCount);
    }
    nanos.push_back(static_cast<double>(cpuNanos() - begin) / frames);
  }
  std::printf("%016llx %lld", static_cast<unsigned long long>(hash), static_cast<long long>(doubts));
  for (double one : nanos) std::printf(" %.3f", one);
  std::printf("\n");
  delete solver;
  return 0;
}
