// The port of the guarded frame and the exact ray cast to C++, over the same bricks. It shows what
// the machine can do.
//
//   palpate-port INPUT PASSES    INPUT as CppPort writes it; prints one line: hash, undecided rays,
//                                nanoseconds of each pass
//
// INPUT says how many of its points belong to one operation: 1 is a frame, 2 are the ends of a ray.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "guarded.h"

namespace {

template <typename T>
void read(FILE* file, T* dest, size_t count) {
  if (std::fread(dest, sizeof(T), count, file) != count) {
    std::fprintf(stderr, "palpate-port: the input is too short\n");
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

void readCube(FILE* file, Cube& cube) {
  int counts[6];
  read(file, counts, 6);
  cube.bricksX = counts[0], cube.bricksY = counts[1], cube.bricksZ = counts[2];
  cube.blocksX = counts[3], cube.blocksY = counts[4], cube.blocksZ = counts[5];
  read(file, cube.low, 3);
  read(file, cube.high, 3);
  cube.bricks.resize(static_cast<size_t>(counts[0]) * counts[1] * counts[2]);
  cube.blocks.resize(static_cast<size_t>(counts[3]) * counts[4] * counts[5]);
  read(file, cube.bricks.data(), cube.bricks.size());
  read(file, cube.blocks.data(), cube.blocks.size());
}

uint64_t followAll(Guarded& solver, const std::vector<Vec>& positions) {
  solver.reset();
  solver.p = positions[0];
  uint64_t hash = 0;
  for (const Vec& d : positions) {
    solver.follow(d);
    hash = hash * 31 + bits(solver.p.c[0]) + 7 * bits(solver.p.c[1]) + 13 * bits(solver.p.c[2]) +
           solver.contact + 3 * static_cast<uint64_t>(solver.legCount);
  }
  return hash;
}

uint64_t castAll(const Cube& cube, const std::vector<Vec>& ends) {
  uint64_t hash = 0;
  Hit hit{};
  for (size_t n = 0; n < ends.size(); n += 2) {
    bool found = cast(cube, ends[n], ends[n + 1], hit);
    hash = hash * 31 + (found ? bits(hit.t) + 7 * static_cast<uint64_t>(hit.axis + 1) : 0);
  }
  return hash;
}

}  // namespace

int main(int argc, char** argv) {
  FILE* file = argc == 3 ? std::fopen(argv[1], "rb") : nullptr;
  if (!file) {
    std::fprintf(stderr, "usage: palpate-port INPUT PASSES\n");
    return 2;
  }
  Cube cube;
  int points, pointsEach;
  double maxStep;
  readCube(file, cube);
  read(file, &points, 1);
  read(file, &pointsEach, 1);
  read(file, &maxStep, 1);
  std::vector<Vec> positions(points);
  read(file, positions.data(), positions.size());
  std::fclose(file);
  Guarded* solver = new Guarded(cube, maxStep);
  std::vector<double> nanos;
  uint64_t hash = 0;
  for (int pass = 0; pass < std::atoi(argv[2]); pass++) {
    int64_t begin = cpuNanos();
    hash = pointsEach == 1 ? followAll(*solver, positions) : castAll(cube, positions);
    nanos.push_back(static_cast<double>(cpuNanos() - begin) * pointsEach / points);
  }
  std::printf("%016llx %lld", static_cast<unsigned long long>(hash),
              static_cast<long long>(doubts));
  for (double one : nanos) std::printf(" %.3f", one);
  std::printf("\n");
  delete solver;
  return 0;
}
