package org.palpate.volume.phantom;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * A head that looks towards y = 0 with z up. The skull has orbits, nasal bones, a nasal cavity with
 * its septum, and sinuses whose walls are one voxel thick. The jaw touches nothing, and a skin
 * surrounds all. Lengths below are fractions of the edge.
 */
final class HeadAnatomy implements Anatomy {
  static final int SKULL = 1;
  static final int JAW = 2;
  static final int SKIN = 3;

  /** The grey value of skin; that of bone is {@link Phantom#SOLID_GREY}. */
  static final int SKIN_GREY = 400;

  private static final double MIDDLE = 0.503;
  private static final double SKIN_THICKNESS = 0.012;

  /** A path through faces could pass a thinner skin. */
  private static final double MIN_SKIN_VOXELS = 1.0;

  // Regions. The nose has two open halves with a wall between them; the foramen is open too.
  private static final int NOSE_LEFT = 1;
  private static final int NOSE_RIGHT = 2;
  private static final int SKULL_REGION = 3;
  private static final int JAW_REGION = 4;
  private static final int SKIN_REGION = 5;
  private static final int FORAMEN = 6;
  private static final int NASAL_VAULT = 7;
  private static final int FIRST_CAVITY = 8;

  private final double edge;
  private final List<Shape> shapes = new ArrayList<>();
  private final long head;
  private final long belowSkin;
  private final long open;
  private final long foramen;
  private final long nose;
  private final long septum;
  private final long face;
  private final long vault;
  private final long[] cavities;
  private final long skull;
  private final long jaw;

  HeadAnatomy(int edge) {
    this.edge = edge;
    List<Shape> surface = surface();
    head = bits(surface);
    double depth = Math.max(MIN_SKIN_VOXELS, SKIN_THICKNESS * edge);
    belowSkin = bits(surface.stream().map(shape -> shape.shrunk(depth)).toList());
    open = pair(0.105, 0.190, 0.470, 0.068, 0.115, 0.060);
    foramen = bit(Shape.cylinder(at(0, 0.64, 0.2), 0.125 * edge, 0.035 * edge));
    nose = bit(ellipsoid(0, 0.215, 0.350, 0.045, 0.130, 0.075));
    septum = bit(Shape.halfSpace(at(0.004, 0.2, 0.35), unit(1, 0.08, 0.05)));
    face = bit(ellipsoid(0, 0.275, 0.385, 0.175, 0.150, 0.160));
    vault = bit(ellipsoid(0, 0.135, 0.440, 0.032, 0.050, 0.060));
    cavities = cavities();
    skull = face | skullBones();
    jaw = jawBones();
  }

  private List<Shape> surface() {
    return List.of(
        ellipsoid(0, 0.545, 0.585, 0.335, 0.400, 0.365),
        ellipsoid(0, 0.330, 0.335, 0.260, 0.270, 0.290),
        ellipsoid(0, 0.085, 0.395, 0.050, 0.060, 0.075),
        ellipsoid(0, 0.200, 0.165, 0.120, 0.125, 0.085),
        Shape.cylinder(at(0, 0.6, 0.035), 0.365 * edge, 0.165 * edge));
  }

  /**
   * Returns the cavities in order of precedence: where two overlap, the space belongs to the
   * earlier one and the wall to the later one.
   */
  private long[] cavities() {
    List<Long> all = new ArrayList<>();
    for (int side = -1; side <= 1; side += 2) {
      all.add(bit(ellipsoid(side * 0.105, 0.225, 0.345, 0.055, 0.085, 0.075))); // maxillary
      all.add(bit(ellipsoid(side * 0.030, 0.235, 0.465, 0.022, 0.085, 0.055))); // ethmoid
      all.add(bit(ellipsoid(side * 0.035, 0.190, 0.590, 0.040, 0.022, 0.050))); // frontal
    }
    all.add(bit(ellipsoid(0, 0.335, 0.375, 0.045, 0.045, 0.035))); // sphenoid
    all.add(bit(ellipsoid(0, 0.545, 0.590, 0.269, 0.334, 0.294))); // cranial
    return all.stream().mapToLong(Long::longValue).toArray();
  }

  private long skullBones() {
    long cranium = bit(ellipsoid(0, 0.545, 0.590, 0.295, 0.360, 0.320));
    long brow = bit(capsule(-0.123, 0.215, 0.545, 0.123, 0.215, 0.545, 0.03));
    long teeth = bit(ellipsoid(0, 0.2, 0.245, 0.09, 0.075, 0.035));
    long cheeks = 0;
    for (int side = -1; side <= 1; side += 2) {
      cheeks |= bit(capsule(side * 0.15, 0.2, 0.37, side * 0.225, 0.42, 0.40, 0.018));
    }
    return cranium | brow | teeth | cheeks;
  }

  private long jawBones() {
    long bones = bit(ellipsoid(0, 0.205, 0.178, 0.085, 0.07, 0.022));
    for (int side = -1; side <= 1; side += 2) {
      bones |= bit(capsule(0, 0.135, 0.145, side * 0.15, 0.36, 0.155, 0.03));
      bones |= bit(capsule(side * 0.15, 0.36, 0.155, side * 0.17, 0.40, 0.30, 0.026));
    }
    return bones;
  }

  @Override
  public Shape[] shapes() {
    return shapes.toArray(new Shape[0]);
  }

  @Override
  public int region(long inside) {
    if ((inside & head) == 0) {
      return OPEN;
    }
    if ((inside & belowSkin) == 0) {
      return SKIN_REGION;
    }
    if ((inside & open) != 0) {
      return OPEN;
    }
    if ((inside & foramen) != 0) {
      return FORAMEN;
    }
    if ((inside & nose) != 0 && (inside & face) != 0) {
      return (inside & septum) != 0 ? NOSE_LEFT : NOSE_RIGHT;
    }
    return deepRegion(inside);
  }

  private int deepRegion(long inside) {
    if ((inside & vault) != 0) {
      return NASAL_VAULT;
    }
    for (int n = 0; n < cavities.length; n++) {
      if ((inside & cavities[n]) != 0) {
        return FIRST_CAVITY + n;
      }
    }
    if ((inside & skull) != 0) {
      return SKULL_REGION;
    }
    return (inside & jaw) != 0 ? JAW_REGION : OPEN;
  }

  @Override
  public int label(int region) {
    return switch (region) {
      case SKULL_REGION -> SKULL;
      case JAW_REGION -> JAW;
      case SKIN_REGION -> SKIN;
      default -> 0;
    };
  }

  @Override
  public boolean hasWalls(int region) {
    return region == NOSE_RIGHT || region >= NASAL_VAULT;
  }

  @Override
  public int wall(int region, int neighbour) {
    if (region == NOSE_RIGHT) {
      return neighbour == NOSE_LEFT ? SKULL : 0;
    }
    boolean bone = neighbour == SKULL_REGION || neighbour == JAW_REGION;
    boolean noseUnderVault = region == NASAL_VAULT && isNose(neighbour);
    boolean open = noseUnderVault || neighbour == FORAMEN;
    return neighbour >= region || bone || open ? 0 : SKULL;
  }

  private static boolean isNose(int region) {
    return region == NOSE_LEFT || region == NOSE_RIGHT;
  }

  @Override
  public int greyValue(int label) {
    return label == 0 ? 0 : label == SKIN ? SKIN_GREY : Phantom.SOLID_GREY;
  }

  private long bit(Shape shape) {
    shapes.add(shape);
    return 1L << (shapes.size() - 1);
  }

  private long bits(List<Shape> union) {
    return union.stream().mapToLong(this::bit).reduce(0, (a, b) -> a | b);
  }

  private long pair(double side, double y, double z, double rx, double ry, double rz) {
    return bit(ellipsoid(-side, y, z, rx, ry, rz)) | bit(ellipsoid(side, y, z, rx, ry, rz));
  }

  private Shape ellipsoid(double side, double y, double z, double rx, double ry, double rz) {
    return Shape.ellipsoid(at(side, y, z), new Vec3(rx * edge, ry * edge, rz * edge));
  }

  private Shape capsule(
      double side0, double y0, double z0, double side1, double y1, double z1, double radius) {
    return Shape.capsule(at(side0, y0, z0), at(side1, y1, z1), radius * edge);
  }

  private Vec3 at(double side, double y, double z) {
    return new Vec3((MIDDLE + side) * edge, y * edge, z * edge);
  }

  private static Vec3 unit(double x, double y, double z) {
    Vec3 vector = new Vec3(x, y, z);
    return vector.mul(1 / vector.length(), vector);
  }
}
