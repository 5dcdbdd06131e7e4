package org.palpate.volume.phantom;

/** Phantoms that evaluate every shape at every point: slow and obviously correct. */
final class NaivePhantom {
  private NaivePhantom() {}

  static int label(Phantom phantom, int i, int j, int k) {
    if (phantom.kind() == Phantom.Kind.MAZE) {
      return new Maze(phantom.seed()).isWall(i, j, k) ? 1 : 0;
    }
    Anatomy anatomy = PhantomShapes.anatomy(phantom.kind(), phantom.edge(), false);
    return label(anatomy, i + 0.5, j + 0.5, k + 0.5);
  }

  static int grey(Phantom phantom, int i, int j, int k) {
    if (phantom.kind() == Phantom.Kind.MAZE) {
      return mazeGrey(phantom, i, j, k);
    }
    Anatomy anatomy = PhantomShapes.anatomy(phantom.kind(), phantom.edge(), true);
    int whole = label(anatomy, i + 0.5, j + 0.5, k + 0.5);
    if (whole != 0 && anatomy.hasWalls(region(anatomy, i + 0.5, j + 0.5, k + 0.5))) {
      return anatomy.greyValue(whole);
    }
    double sum = 0;
    for (double z = k + 0.125; z < k + 1; z += 0.25) {
      for (double y = j + 0.125; y < j + 1; y += 0.25) {
        for (double x = i + 0.125; x < i + 1; x += 0.25) {
          sum += anatomy.greyValue(anatomy.label(region(anatomy, x, y, z)));
        }
      }
    }
    return (int) Math.round(sum / 64);
  }

  private static int mazeGrey(Phantom phantom, int i, int j, int k) {
    if (label(phantom, i, j, k) != 0) {
      return Phantom.SOLID_GREY;
    }
    int sum = 0;
    for (int side = -1; side <= 1; side += 2) {
      sum += label(phantom, i + side, j, k);
      sum += label(phantom, i, j + side, k);
      sum += label(phantom, i, j, k + side);
    }
    return 75 * sum;
  }

  private static int label(Anatomy anatomy, double x, double y, double z) {
    int region = region(anatomy, x, y, z);
    if (!anatomy.hasWalls(region)) {
      return anatomy.label(region);
    }
    int best = 0;
    double[][] sides = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (double[] side : sides) {
      int neighbour = region(anatomy, x + side[0], y + side[1], z + side[2]);
      best = Math.max(best, anatomy.wall(region, neighbour));
    }
    return best;
  }

  private static int region(Anatomy anatomy, double x, double y, double z) {
    Shape[] shapes = anatomy.shapes();
    long inside = 0;
    for (int s = 0; s < shapes.length; s++) {
      inside |= shapes[s].at(x, y, z) <= 0 ? 1L << s : 0;
    }
    return anatomy.region(inside);
  }
}
