package org.palpate.benchmarks.stress;

import java.util.SplittableRandom;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * A small scene that challenges geometric tests.
 *
 * @param kind the kind, for messages
 * @param bits the solids
 * @param spacingMm the spacing, up to 1:1:20
 * @param maxStepMm w_max, from tiny to huge
 */
public record HostileScene(String kind, BitCube bits, Vec3 spacingMm, double maxStepMm) {
  private static final int LARGEST = 20;

  /** A rule for solid voxels. */
  private interface Rule {
    boolean isSolid(int i, int j, int k);
  }

  /** Returns a random scene. */
  public static HostileScene next(SplittableRandom random) {
    int sizeX = size(random);
    int sizeY = size(random);
    int sizeZ = size(random);
    int kind = random.nextInt(11);
    BitCube bits =
        kind == 0 ? crop(mazeOf(random), random) : fill(sizeX, sizeY, sizeZ, rule(kind, random));
    ensureSolid(bits, random);
    return new HostileScene(nameOf(kind), bits, spacing(random), maxStep(random));
  }

  private static String nameOf(int kind) {
    String[] names = {
      "maze",
      "diagonal walls",
      "single voxels",
      "checkerboard",
      "comb",
      "wires",
      "shell",
      "noise",
      "faces",
      "slope",
      "box"
    };
    return names[kind];
  }

  private static Rule rule(int kind, SplittableRandom random) {
    return switch (kind) {
      case 1 -> diagonalWalls(random);
      case 2 -> noise(random, 0.02);
      case 3 -> checkerboard(random);
      case 4 -> comb(random);
      case 5 -> wires(random);
      case 6 -> shell(random);
      case 7 -> noise(random, 0.1 + 0.6 * random.nextDouble());
      case 8 -> faces(random);
      case 9 -> slope(random);
      default -> box(random);
    };
  }

  private static int size(SplittableRandom random) {
    return random.nextInt(8) == 0 ? 1 : random.nextInt(2, LARGEST + 1);
  }

  private static BitCube fill(int sizeX, int sizeY, int sizeZ, Rule rule) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          if (rule.isSolid(i, j, k)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  /** Diagonal planes of voxels that share only edges and corners, with holes. */
  private static Rule diagonalWalls(SplittableRandom random) {
    int a = sign(random);
    int b = sign(random);
    int c = random.nextInt(3) == 0 ? 0 : sign(random);
    int period = random.nextInt(2, 9);
    int offset = random.nextInt(period);
    long holes = random.nextLong();
    return (i, j, k) ->
        Math.floorMod(a * i + b * j + c * k, period) == offset && (hash(holes, i, j, k) & 31) != 0;
  }

  private static Rule noise(SplittableRandom random, double density) {
    long seed = random.nextLong();
    return (i, j, k) -> (hash(seed, i, j, k) >>> 11) * 0x1p-53 < density;
  }

  private static Rule checkerboard(SplittableRandom random) {
    long holes = random.nextLong();
    int cell = random.nextInt(1, 3);
    return (i, j, k) ->
        (i / cell + j / cell + k / cell & 1) == 0 && (hash(holes, i, j, k) & 7) != 0;
  }

  private static Rule comb(SplittableRandom random) {
    int axis = random.nextInt(3);
    int pitch = random.nextInt(2, 5);
    int back = (axis + 1) % 3;
    return (i, j, k) ->
        (axis == 0 ? i : axis == 1 ? j : k) % pitch == 0
            || (back == 0 ? i : back == 1 ? j : k) == 0;
  }

  private static Rule wires(SplittableRandom random) {
    BitCube wire = new BitCube(LARGEST, LARGEST, LARGEST);
    for (int n = 0; n < 6; n++) {
      int i = random.nextInt(LARGEST);
      int j = random.nextInt(LARGEST);
      int k = random.nextInt(LARGEST);
      for (int step = 0; step < 40; step++) {
        wire.set(i, j, k);
        i = randomStep(i, random);
        j = randomStep(j, random);
        k = randomStep(k, random);
      }
    }
    return wire::get;
  }

  private static int randomStep(int at, SplittableRandom random) {
    return Math.max(0, Math.min(LARGEST - 1, at + random.nextInt(-1, 2)));
  }

  private static Rule shell(SplittableRandom random) {
    Vec3 centre = randomPoint(random);
    double radius = 2 + 6 * random.nextDouble();
    Rule ball = (i, j, k) -> new Vec3(i, j, k).sub(centre, new Vec3()).length() <= radius;
    return (i, j, k) ->
        ball.isSolid(i, j, k)
            && !(ball.isSolid(i - 1, j, k)
                && ball.isSolid(i + 1, j, k)
                && ball.isSolid(i, j - 1, k)
                && ball.isSolid(i, j + 1, k)
                && ball.isSolid(i, j, k - 1)
                && ball.isSolid(i, j, k + 1));
  }

  /** Solid voxels at every face of the grid. */
  private static Rule faces(SplittableRandom random) {
    long seed = random.nextLong();
    return (i, j, k) ->
        (i == 0 || j == 0 || k == 0 || i > 3 || j > 3 || k > 3) && (hash(seed, i, j, k) & 3) == 0;
  }

  private static Rule slope(SplittableRandom random) {
    Vec3 point = randomPoint(random);
    Vec3 normal = randomPoint(random);
    normal.sub(new Vec3(LARGEST / 2.0, LARGEST / 2.0, LARGEST / 2.0), normal);
    return (i, j, k) -> new Vec3(i, j, k).sub(point, new Vec3()).dot(normal) <= 0;
  }

  private static Rule box(SplittableRandom random) {
    int low = random.nextInt(0, 6);
    int high = random.nextInt(6, LARGEST);
    return (i, j, k) -> Math.min(i, Math.min(j, k)) >= low && Math.max(i, Math.max(j, k)) <= high;
  }

  private static Vec3 randomPoint(SplittableRandom random) {
    return new Vec3(
        LARGEST * random.nextDouble(),
        LARGEST * random.nextDouble(),
        LARGEST * random.nextDouble());
  }

  private static BitCube mazeOf(SplittableRandom random) {
    Phantom maze = new Phantom(Phantom.Kind.MAZE, 32, false, random.nextLong());
    return maze.segments().segments().get(0).bits();
  }

  private static BitCube crop(BitCube from, SplittableRandom random) {
    int atX = random.nextInt(12);
    int atY = random.nextInt(12);
    int atZ = random.nextInt(12);
    return fill(LARGEST, LARGEST, LARGEST, (i, j, k) -> from.get(i + atX, j + atY, k + atZ));
  }

  private static void ensureSolid(BitCube bits, SplittableRandom random) {
    if (bits.solidCount() == 0) {
      bits.set(
          random.nextInt(bits.sizeX()), random.nextInt(bits.sizeY()), random.nextInt(bits.sizeZ()));
    }
  }

  private static Vec3 spacing(SplittableRandom random) {
    return switch (random.nextInt(4)) {
      case 0 -> new Vec3(1, 1, 2);
      case 1 -> new Vec3(1, 1, 20);
      case 2 ->
          new Vec3(
              0.1 + random.nextDouble(), 0.1 + random.nextDouble(), 0.1 + 5 * random.nextDouble());
      default -> new Vec3(1, 1, 1);
    };
  }

  private static double maxStep(SplittableRandom random) {
    return switch (random.nextInt(8)) {
      case 0 -> 1e-6;
      case 1 -> random.nextBoolean() ? 1e9 : 1e301;
      case 2 -> random.nextDouble() + 0.01;
      default -> 8;
    };
  }

  private static int sign(SplittableRandom random) {
    return random.nextBoolean() ? 1 : -1;
  }

  private static long hash(long seed, int i, int j, int k) {
    long z = seed + i * 0x9E3779B97F4A7C15L + j * 0xC2B2AE3D27D4EB4FL + k * 0x165667B19E3779F9L;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** Returns the metric of the grid. */
  GridMetric metric() {
    return GridMetric.of(spacingMm);
  }
}
