package org.palpate.benchmarks.baseline;

import org.palpate.volume.BitCube;

/**
 * The plain baseline: the paper's solver of 2013 over a flat bit array, in straightforward code. It
 * has one condition more than the listing, so that it comes to rest: a neighbour must be strictly
 * nearer to d than p. Collision samples are one voxel apart; distances are in voxels.
 *
 * <p>It uses nothing of the library's own frames. Source: Vlasov, Friese, Wolter 2013, section 4.2.
 */
public final class PlainBaseline {
  /** The largest number below 1, so that p stops at the last free sample. */
  private static final double EPSILON = 1 - 0x1p-53;

  private static final double MISS = -1;

  private final FlatBits bits;
  private final double maxPath;

  private double px;
  private double py;
  private double pz;
  private double dx;
  private double dy;
  private double dz;
  private double path;
  private double surfacePath;
  private boolean contact;

  /** Copies the voxels; {@code maxPath} is w_max in voxels. */
  public PlainBaseline(BitCube cube, double maxPath) {
    bits = new FlatBits(cube);
    this.maxPath = maxPath;
  }

  /** Places p, grid coordinates. */
  public void place(double x, double y, double z) {
    px = x;
    py = y;
    pz = z;
  }

  /** Returns x of p. */
  public double x() {
    return px;
  }

  /** Returns y of p. */
  public double y() {
    return py;
  }

  /** Returns z of p. */
  public double z() {
    return pz;
  }

  /** Whether the last frame met a solid. */
  public boolean contact() {
    return contact;
  }

  /** Returns the length of the last frame's path, voxels. */
  public double path() {
    return path;
  }

  /** Returns the length of the last frame's path through border voxels, voxels. */
  public double surfacePath() {
    return surfacePath;
  }

  /** Lets p follow the device for one frame. */
  public void frame(double deviceX, double deviceY, double deviceZ) {
    dx = deviceX;
    dy = deviceY;
    dz = deviceZ;
    path = 0;
    surfacePath = 0;
    contact = false;
    boolean moved = true;
    while (!(px == dx && py == dy && pz == dz) && path < maxPath && moved) {
      double lastX = px;
      double lastY = py;
      double lastZ = pz;
      double hit = firstSolidSample();
      if (hit == MISS) {
        path += moveTowards(dx, dy, dz, maxPath - path);
        return;
      }
      contact = true;
      stopBefore(hit);
      followSurface();
      moved = px != lastX || py != lastY || pz != lastZ;
    }
  }

  private double firstSolidSample() {
    double ux = dx - px;
    double uy = dy - py;
    double uz = dz - pz;
    double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
    for (double at = 1; at < length; at++) {
      double t = at / length;
      if (bits.solidAt(px + t * ux, py + t * uy, pz + t * uz)) {
        return at;
      }
    }
    return bits.solidAt(dx, dy, dz) ? length : MISS;
  }

  private void stopBefore(double hit) {
    double length = distance(px, py, pz, dx, dy, dz);
    double step = Math.min(hit - EPSILON, maxPath - path);
    if (step > 0) {
      double t = step / length;
      double x = px + t * (dx - px);
      double y = py + t * (dy - py);
      double z = pz + t * (dz - pz);
      if (!bits.solidAt(x, y, z)) {
        px = x;
        py = y;
        pz = z;
        path += step;
      }
    }
  }

  private void followSurface() {
    while (path < maxPath && !(px == dx && py == dy && pz == dz)) {
      if (straightIsFree()) {
        return;
      }
      int i = (int) Math.floor(px);
      int j = (int) Math.floor(py);
      int k = (int) Math.floor(pz);
      int best = nearestBorderVoxel(i, j, k);
      if (best < 0) {
        return;
      }
      double step = moveToVoxel(i + best % 3 - 1, j + best / 3 % 3 - 1, k + best / 9 - 1);
      if (step == 0) {
        return;
      }
      path += step;
      surfacePath += step;
    }
  }

  private boolean straightIsFree() {
    double t = Math.min(1, 1 / distance(px, py, pz, dx, dy, dz));
    return !bits.solidAt(px + t * (dx - px), py + t * (dy - py), pz + t * (dz - pz));
  }

  /** Returns the number of the neighbour, 0 to 26, or -1 if none is nearer to d than p. */
  private int nearestBorderVoxel(int i, int j, int k) {
    double least = squared(px, py, pz, dx, dy, dz);
    int best = -1;
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      double square = squared(x + 0.5, y + 0.5, z + 0.5, dx, dy, dz);
      if (n != 13 && square < least && border(x, y, z)) {
        least = square;
        best = n;
      }
    }
    return best;
  }

  private boolean border(int i, int j, int k) {
    if (bits.solid(i, j, k)) {
      return false;
    }
    for (int z = k - 1; z <= k + 1; z++) {
      for (int y = j - 1; y <= j + 1; y++) {
        for (int x = i - 1; x <= i + 1; x++) {
          if (bits.solid(x, y, z)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private double moveToVoxel(int i, int j, int k) {
    double x = px;
    double y = py;
    double z = pz;
    double step = moveTowards(i + 0.5, j + 0.5, k + 0.5, maxPath - path);
    if (!bits.solidAt(px, py, pz)) {
      return step;
    }
    px = x;
    py = y;
    pz = z;
    return 0;
  }

  private double moveTowards(double x, double y, double z, double atMost) {
    double length = distance(px, py, pz, x, y, z);
    if (length <= atMost) {
      px = x;
      py = y;
      pz = z;
      return length;
    }
    double t = atMost / length;
    px += t * (x - px);
    py += t * (y - py);
    pz += t * (z - pz);
    return atMost;
  }

  private static double distance(double x0, double y0, double z0, double x1, double y1, double z1) {
    return Math.sqrt(squared(x0, y0, z0, x1, y1, z1));
  }

  private static double squared(double x0, double y0, double z0, double x1, double y1, double z1) {
    double x = x1 - x0;
    double y = y1 - y0;
    double z = z1 - z0;
    return x * x + y * y + z * z;
  }
}
