// Bricks and the exact ray cast over them, for the C++ port. It follows NearRayTraversal and
// FarRayTraversal step by step, so that every double is the same (no fused multiply-add). A ray that
// doubles cannot decide is counted and reported as a miss; Java decides it by its exact traversal.
//
// One program with one translation unit: the unnamed namespace lets single calls be inlined.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

constexpr double kNearVoxels = 10;
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
    return (brick(i >> 2, y, z) >> shift & kept) |
           (brick((i >> 2) + 1, y, z) << (4 - shift) & ~kept);
  }
  uint64_t slab(int i, int j, int z) const {
    int shift = (j & 3) << 2;
    uint64_t kept = static_cast<uint64_t>(0xffff >> shift) * 0x0001000100010001u;
    return (row(i, j >> 2, z) >> shift & kept) | (row(i, (j >> 2) + 1, z) << (16 - shift) & ~kept);
  }
  uint64_t rowInside(int i, size_t at) const {
    int shift = i & 3;
    uint64_t kept = static_cast<uint64_t>(0xf >> shift) * 0x1111111111111111u;
    return (bricks[at] >> shift & kept) | (bricks[at + 1] << (4 - shift) & ~kept);
  }
  uint64_t slabInside(int i, int j, size_t at) const {
    int shift = (j & 3) << 2;
    uint64_t kept = static_cast<uint64_t>(0xffff >> shift) * 0x0001000100010001u;
    return (rowInside(i, at) >> shift & kept) |
           (rowInside(i, at + bricksX) << (16 - shift) & ~kept);
  }
  uint64_t window(int i, int j, int k) const {
    int shift = (k & 3) << 4;
    int x = i >> 2, y = j >> 2, z = k >> 2;
    if (x >= 0 && x < bricksX - 1 && y >= 0 && y < bricksY - 1 && z >= 0 && z < bricksZ - 1) {
      size_t at = (static_cast<size_t>(z) * bricksY + y) * bricksX + x;
      size_t above = at + static_cast<size_t>(bricksX) * bricksY;
      return slabInside(i, j, at) >> shift | slabInside(i, j, above) << (48 - shift) << 16;
    }
    return slab(i, j, z) >> shift | slab(i, j, z + 1) << (48 - shift) << 16;
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
    if ((before ^ cell[axis]) >> 2 != 0)
      brick = cube.brick(cell[0] >> 2, cell[1] >> 2, cell[2] >> 2);
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
    if (std::max(from.c[a], to.c[a]) < cube.low[a] ||
        std::min(from.c[a], to.c[a]) > cube.high[a] + 1.0)
      return false;
    isNear = isNear && std::fabs(to.c[a] - from.c[a]) <= kNearVoxels;
  }
  Answer answer = isNear ? nearWalk(cube, from, to, hit) : farWalk(cube, from, to, hit);
  doubts += answer == kDoubt;
  return answer == kHit;
}

}  // namespace
