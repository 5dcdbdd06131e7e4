// Judges legs, exact segments between two points, against closed solid voxels.
// Voxels are bricks of 4x4x4 in the bit order of org.palpate.volume.BitCube; outside is empty.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable

// Coordinates must have the bits of Java, so products and sums must not be fused.
#pragma OPENCL FP_CONTRACT OFF

// The order of org.palpate.collision.LegVerdict.
#define FREE 0
#define HIT 1
#define DOUBT 2

// The host decides legs whose box is longer, or that need more tests. This bounds the work.
#define MOST_CELLS 32
#define MOST_TESTS 96

// The filter of org.palpate.raycast.ExactPredicates: its relative and its absolute error bound.
#define RELATIVE_ERROR 0x1p-51
#define UNDERFLOW_ERROR 0x1p-1070

// Coordinates beyond it do not fit into an int.
#define FARTHEST 0x1p29

// The cubes of org.palpate.collision.EmptyCube: half the edge of the smallest, and their number.
#define SMALLEST_REACH 0.25
#define MOST_CUBES 5

typedef struct {
  __global const ulong* bricks;
  int bricksX;
  int bricksY;
  int bricksZ;
} Cube;

ulong brickAt(Cube cube, int x, int y, int z) {
  int outside = x < 0 || y < 0 || z < 0 || x >= cube.bricksX || y >= cube.bricksY || z >= cube.bricksZ;
  return outside ? 0 : cube.bricks[(z * cube.bricksY + y) * cube.bricksX + x];
}

// Returns the voxels of a brick between two local layers of each axis, both included.
ulong layers(int3 low, int3 high) {
  ulong x = (ulong) ((2 << high.x) - (1 << low.x)) * 0x1111111111111111UL;
  ulong y = (ulong) ((16 << (high.y << 2)) - (1 << (low.y << 2))) * 0x0001000100010001UL;
  ulong z = (~0UL >> ((3 - high.z) << 4)) & (~0UL << (low.z << 4));
  return x & y & z;
}

// Returns the sign of (c - a) x (b - a) if rounding cannot change it, otherwise 0.
int sureSide(double ax, double ay, double bx, double by, double cx, double cy) {
  double left = (cx - ax) * (by - ay);
  double right = (cy - ay) * (bx - ax);
  double difference = left - right;
  double bound = RELATIVE_ERROR * (fabs(left) + fabs(right)) + UNDERFLOW_ERROR;
  return difference > bound ? 1 : difference < -bound ? -1 : 0;
}

// Whether the line through a and b meets a closed unit square. The two corners that lie farthest
// to either side of the line decide.
int lineMeetsSquare(double ax, double ay, double bx, double by, int lowX, int lowY) {
  if (ax == bx && ay == by) {
    return HIT; // a point in this plane, inside the square because the leg's box meets the voxel
  }
  int up = by > ay;
  int right = bx > ax;
  int most = sureSide(ax, ay, bx, by, (double) lowX + up, (double) lowY + 1 - right);
  int least = sureSide(ax, ay, bx, by, (double) lowX + 1 - up, (double) lowY + right);
  return most < 0 || least > 0 ? FREE : most > 0 && least < 0 ? HIT : DOUBT;
}

// Whether a leg meets a closed voxel that its box meets.
int legMeetsVoxel(double3 a, double3 b, int i, int j, int k) {
  int xy = lineMeetsSquare(a.x, a.y, b.x, b.y, i, j);
  int yz = lineMeetsSquare(a.y, a.z, b.y, b.z, j, k);
  int zx = lineMeetsSquare(a.z, a.x, b.z, b.x, k, i);
  if (xy == FREE || yz == FREE || zx == FREE) {
    return FREE;
  }
  return xy == DOUBT || yz == DOUBT || zx == DOUBT ? DOUBT : HIT;
}

// False for NaN too.
int isNear(double3 p) {
  return fabs(p.x) < FARTHEST && fabs(p.y) < FARTHEST && fabs(p.z) < FARTHEST;
}

// Returns the lowest cell whose closed voxel contains a coordinate.
int lowestCell(double coordinate) {
  double cell = floor(coordinate);
  return (int) cell - (cell == coordinate);
}

int judgeLeg(Cube cube, double3 a, double3 b) {
  if (!isNear(a) || !isNear(b)) {
    return DOUBT;
  }
  double3 least = fmin(a, b);
  double3 most = fmax(a, b);
  int3 low = (int3) (lowestCell(least.x), lowestCell(least.y), lowestCell(least.z));
  int3 high = (int3) ((int) floor(most.x), (int) floor(most.y), (int) floor(most.z));
  int3 size = high - low;
  if (size.x >= MOST_CELLS || size.y >= MOST_CELLS || size.z >= MOST_CELLS) {
    return DOUBT;
  }
  int verdict = FREE;
  int tests = 0;
  for (int z = low.z >> 2; z <= high.z >> 2; z++) {
    for (int y = low.y >> 2; y <= high.y >> 2; y++) {
      for (int x = low.x >> 2; x <= high.x >> 2; x++) {
        int3 corner = (int3) (x << 2, y << 2, z << 2);
        ulong solids = brickAt(cube, x, y, z);
        solids &= layers(max(low - corner, 0), min(high - corner, 3));
        for (; solids != 0; solids &= solids - 1) {
          int bit = 63 - (int) clz(solids & -solids);
          int k = corner.z + (bit >> 4);
          int one = legMeetsVoxel(a, b, corner.x + (bit & 3), corner.y + (bit >> 2 & 3), k);
          if (one == HIT) {
            return HIT;
          }
          verdict = one == DOUBT ? DOUBT : verdict;
          if (++tests == MOST_TESTS) {
            return DOUBT;
          }
        }
      }
    }
  }
  return verdict;
}

// Returns a component of org.palpate.geometry.AffineMap, with its bits: a row and an offset.
double component(__global const double* row, double x, double y, double z) {
  double byX = row[0] * x;
  double byY = row[1] * y;
  double byZ = row[2] * z;
  double sum = byX + byY;
  sum = sum + byZ;
  return sum + row[3];
}

double3 image(__global const double* map, double x, double y, double z) {
  return (double3) (
      component(map, x, y, z), component(map + 4, x, y, z), component(map + 8, x, y, z));
}

// Whether a closed cube around a point touches no solid voxel. reach: half of its edge.
int isCubeEmpty(Cube cube, double3 p, double reach) {
  double3 least = p - reach;
  double3 most = p + reach;
  int3 low = (int3) (lowestCell(least.x), lowestCell(least.y), lowestCell(least.z));
  int3 high = (int3) ((int) floor(most.x), (int) floor(most.y), (int) floor(most.z));
  for (int z = low.z >> 2; z <= high.z >> 2; z++) {
    for (int y = low.y >> 2; y <= high.y >> 2; y++) {
      for (int x = low.x >> 2; x <= high.x >> 2; x++) {
        int3 corner = (int3) (x << 2, y << 2, z << 2);
        ulong solids = brickAt(cube, x, y, z);
        if ((solids & layers(max(low - corner, 0), min(high - corner, 3))) != 0) {
          return 0;
        }
      }
    }
  }
  return 1;
}

// Returns the number of doublings, from SMALLEST_REACH on, whose cubes around a point are empty.
int emptyCubes(Cube cube, double3 p) {
  double reach = SMALLEST_REACH;
  int cubes = 0;
  while (cubes < MOST_CUBES && isNear(p) && isCubeEmpty(cube, p, reach)) {
    reach *= 2;
    cubes++;
  }
  return cubes;
}

// Judges the leg of each point in each motion: between the images under two maps.
// points: all x, then all y, then all z. motions: their number, the map at the start of all, then
// the map at the end of each, in rows. verdicts: those of all points in the first motion, then in
// the second, and so on. Those of the first also hold the empty cubes around the start.
__kernel void judge(
    __global const ulong* bricks, int bricksX, int bricksY, int bricksZ,
    __global const double* points, int count,
    __global const double* motions, __global uchar* verdicts) {
  int id = get_global_id(0);
  if (id >= (int) motions[0] * count) {
    return;
  }
  int motion = id / count;
  int point = id - motion * count;
  Cube cube = {bricks, bricksX, bricksY, bricksZ};
  double x = points[point];
  double y = points[count + point];
  double z = points[2 * count + point];
  double3 start = image(motions + 1, x, y, z);
  int verdict = judgeLeg(cube, start, image(motions + 13 + 12 * motion, x, y, z));
  int cubes = motion == 0 ? emptyCubes(cube, start) : 0;
  verdicts[id] = (uchar) (verdict | cubes << 2);
}

// Replaces bricks. changes: their number, then pairs of index and word.
__kernel void change(__global ulong* bricks, __global const ulong* changes) {
  ulong id = get_global_id(0);
  if (id < changes[0]) {
    bricks[changes[2 * id + 1]] = changes[2 * id + 2];
  }
}
