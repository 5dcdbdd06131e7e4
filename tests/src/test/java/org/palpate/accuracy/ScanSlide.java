package org.palpate.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A slide of the device below the outer surface of a scan, in one slice. It follows the longest arc
 * around the middle of the solids on which rays from outside meet the surface without a gap and
 * with enough solid behind it and in the adjacent slices. The surface is smoothed along the arc, so
 * that the slide has no steps of its own. Grid coordinates.
 */
final class ScanSlide {
  /** The distance between two rays on the arc. */
  private static final double RAY_STEP_MM = 0.25;

  /** A larger step between two rays is a gap. */
  private static final double MAX_JUMP_MM = 2.5;

  private static final double SMOOTHING_MM = 6;
  private static final double MARCH_MM = 0.05;
  private static final double APPROACH_MM = 4;
  private static final double STEP_MM = 0.2;
  private static final int SLICE_STEP = 4;

  /** Additional solid around the device, so that the surface is the nearest free point. */
  private static final double BESIDE_MM = 2;

  private final BitCube bits;
  private final Vec3 spacing;
  private final double middleX;
  private final double middleY;
  private final double farthestMm;
  private final double depthMm;

  private ScanSlide(BitCube bits, Vec3 spacing, double depthMm) {
    this.depthMm = depthMm;
    this.bits = bits;
    this.spacing = spacing;
    middleX = (bits.bounds().lowX + bits.bounds().highX + 1) * 0.5 * spacing.x;
    middleY = (bits.bounds().lowY + bits.bounds().highY + 1) * 0.5 * spacing.y;
    farthestMm = Math.hypot(bits.sizeX() * spacing.x, bits.sizeY() * spacing.y) / 2;
  }

  /** Returns the device positions: an approach from outside, then the slide. */
  static List<Vec3> below(BitCube bits, Vec3 spacing, double depthMm) {
    ScanSlide slide = new ScanSlide(bits, spacing, depthMm);
    Arc best = null;
    for (int k = bits.bounds().lowZ; k <= bits.bounds().highZ; k += SLICE_STEP) {
      Arc arc = slide.longestArc(k);
      best = best == null || arc.radii.size() > best.radii.size() ? arc : best;
    }
    return slide.positions(best);
  }

  /** The radii of successive rays from an angle on, in the middle of a slice. */
  private record Arc(int slice, double fromAngle, double angleStep, List<Double> radii) {}

  private Arc longestArc(int slice) {
    double angleStep = RAY_STEP_MM / (farthestMm / 2);
    int rays = (int) (2 * Math.PI / angleStep);
    Arc best = new Arc(slice, 0, angleStep, List.of());
    List<Double> run = new ArrayList<>();
    for (int ray = 0; ray < rays; ray++) {
      double radius = radius(slice, ray * angleStep);
      if (!run.isEmpty() && !(Math.abs(radius - run.get(run.size() - 1)) <= MAX_JUMP_MM)) {
        run = new ArrayList<>();
      }
      if (radius > 0) {
        run.add(radius);
        double from = (ray - run.size() + 1) * angleStep;
        best = run.size() > best.radii.size() ? new Arc(slice, from, angleStep, run) : best;
      }
    }
    return best;
  }

  /** Returns the distance from the middle to the first solid from outside, mm; 0 if none. */
  private double radius(int slice, double angle) {
    double x = StrictMath.cos(angle);
    double y = StrictMath.sin(angle);
    for (double r = farthestMm; r > 0; r -= MARCH_MM) {
      if (isSolid(r * x, r * y, slice)) {
        return isThick(r, x, y, slice) ? r : 0;
      }
    }
    return 0;
  }

  private boolean isSolid(double xMm, double yMm, int slice) {
    int i = (int) Math.floor((middleX + xMm) / spacing.x);
    int j = (int) Math.floor((middleY + yMm) / spacing.y);
    return bits.get(i, j, slice);
  }

  /** Whether it is solid down to the device's depth, in this slice and in the adjacent ones. */
  private boolean isThick(double radiusMm, double x, double y, int slice) {
    int beside = (int) Math.ceil((depthMm + BESIDE_MM) / spacing.z);
    for (double r = radiusMm - BESIDE_MM; r > radiusMm - depthMm - BESIDE_MM; r -= 0.5) {
      for (int k = slice - beside; k <= slice + beside; k++) {
        if (!isSolid(r * x, r * y, k)) {
          return false;
        }
      }
    }
    return true;
  }

  private List<Vec3> positions(Arc arc) {
    List<Vec3> positions = new ArrayList<>();
    double[] radii = smoothed(arc.radii);
    for (double above = APPROACH_MM; above > -depthMm; above -= STEP_MM / 2) {
      positions.add(at(arc, 0, radii[0] + above));
    }
    Vec3 last = positions.get(positions.size() - 1);
    for (int ray = 0; ray < radii.length; ray++) {
      Vec3 next = at(arc, ray, radii[ray] - depthMm);
      int steps = (int) Math.ceil(distanceMm(last, next) / STEP_MM);
      for (int step = 1; step <= steps; step++) {
        positions.add(next.sub(last, new Vec3()).mul(step / (double) steps, new Vec3()));
        positions.get(positions.size() - 1).add(last, positions.get(positions.size() - 1));
      }
      last = next;
    }
    return positions;
  }

  private double distanceMm(Vec3 a, Vec3 b) {
    return Math.hypot((a.x - b.x) * spacing.x, (a.y - b.y) * spacing.y);
  }

  private static double[] smoothed(List<Double> radii) {
    int reach = (int) (SMOOTHING_MM / RAY_STEP_MM);
    double[] once = new double[radii.size()];
    for (int n = 0; n < once.length; n++) {
      int from = Math.max(0, n - reach);
      int to = Math.min(once.length, n + reach + 1);
      once[n] =
          radii.subList(from, to).stream().mapToDouble(Double::doubleValue).average().orElse(0);
    }
    return once;
  }

  private Vec3 at(Arc arc, int ray, double radiusMm) {
    double angle = arc.fromAngle + ray * arc.angleStep;
    return new Vec3(
        (middleX + radiusMm * StrictMath.cos(angle)) / spacing.x,
        (middleY + radiusMm * StrictMath.sin(angle)) / spacing.y,
        arc.slice + 0.5);
  }
}
