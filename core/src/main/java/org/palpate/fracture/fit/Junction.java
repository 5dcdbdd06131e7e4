package org.palpate.fracture.fit;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Scores the fit of a fragment to another. A pose leads from the rest of the fragment to the rest
 * of the other. Surface points in contact speak for it, and so do points on skin that goes on in
 * the skin of the other. Points that face the other at a distance, or lie inside it, speak against
 * it. Thin bones have small faces, so their skin decides more. One thread an instance.
 */
final class Junction {
  /** The largest cosine between normals that face each other. */
  private static final double FACING_COSINE = -0.5;

  /** The least cosine between normals of skin that goes on. */
  private static final double SKIN_COSINE = 0.85;

  /** The distance beyond the nearest point at which the skin of the other is read, edges. */
  private static final double BEYOND_EDGES = 2;

  /** The least distance, across the normal, from skin to the nearest point of the other, edges. */
  private static final double BESIDE_EDGES = 0.7;

  /** The largest deviation from the gap at which faces are in contact, edges. */
  private static final double CONTACT_EDGES = 0.6;

  /** The value of 1 + cosine between the normals from which contact counts nothing. */
  private static final double UNLIKE = 0.08;

  /** The depth from which a point counts as inside, edges. */
  private static final double INSIDE_EDGES = 1.5;

  /** The largest distance of a point that faces the other, edges. */
  private static final double OPEN_EDGES = 4;

  /** The same deviation for faces that were fitted exactly, edges. */
  private static final double EXACT_EDGES = 0.2;

  /** The weight of contact that is exact, which few poses but the true one have. */
  private static final double EXACT_WEIGHT = 4;

  private static final double SKIN_WEIGHT = 0.5;
  private static final double INSIDE_COST = 2;
  private static final double OPEN_COST = 0.5;

  /** The distance from which points count nothing in a rough score, edges. */
  private static final double ROUGH_EDGES = 1.5;

  /** The depth from which points count as inside in a rough score, edges. */
  private static final double ROUGH_INSIDE_EDGES = 3;

  /** The largest share of the points that may lie inside the other in a rough score. */
  private static final double MOST_INSIDE = 0.15;

  private static final int LEAST_PAIRS = 12;
  private static final int STEPS = 12;
  private static final double LEAST_NOISE_EDGES = 0.05;

  /** The longest step, edges. */
  private static final double STEP_EDGES = 2;

  /** A step shorter than this ends the motion, edges. */
  private static final double SMALL_STEP_EDGES = 0.02;

  private final FragmentSurface surface;
  private final SurfaceCells faced;
  private final double edgeMm;
  private final double gapMm;
  private final AffineMap map = new AffineMap();
  private final Vec3 at = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 along = new Vec3();
  private final Vec3 centre = new Vec3();
  private final Quaternion turn = new Quaternion();

  /**
   * Creates a junction of two fragments.
   *
   * @param surface the surface of the fragment
   * @param faced the surface of the other fragment
   * @param edgeMm the edge of a voxel, mm
   * @param gapMm the width of the gap between faces that fit, mm
   */
  Junction(FragmentSurface surface, SurfaceCells faced, double edgeMm, double gapMm) {
    this.surface = surface;
    this.faced = faced;
    this.edgeMm = edgeMm;
    this.gapMm = gapMm;
  }

  /** Moves to the place of a point. Returns whether it is near the other surface. */
  private boolean goTo(int n) {
    map.transform(surface.points().get(n), at);
    Vec3 m = surface.normals().get(n);
    normal.set(
        map.mXX * m.x + map.mXY * m.y + map.mXZ * m.z,
        map.mYX * m.x + map.mYY * m.y + map.mYZ * m.z,
        map.mZX * m.x + map.mZY * m.y + map.mZZ * m.z);
    return faced.place(at.x, at.y, at.z) == SurfaceCells.Place.NEAR;
  }

  private boolean faces(int n) {
    return goTo(n) && faced.normal().dot(normal) <= FACING_COSINE;
  }

  /** Returns how well a point is in contact, 0 to 1. */
  private double contact(int n, double widthMm) {
    return faces(n) ? bell((faced.heightMm() - gapMm) / widthMm) : 0;
  }

  /** Returns how well the skin at a point goes on in that of the other, 0 to 1. */
  private double skin(int n, double widthMm) {
    if (!goTo(n)) {
      return 0;
    }
    faced.point().sub(at, along);
    double height = along.dot(normal);
    along.set(
        along.x - height * normal.x, along.y - height * normal.y, along.z - height * normal.z);
    double length = along.length();
    if (length < BESIDE_EDGES * edgeMm) {
      return 0;
    }
    at.add(along.mul(1 + BEYOND_EDGES * edgeMm / length, along), at);
    return faced.place(at.x, at.y, at.z) == SurfaceCells.Place.NEAR
            && faced.normal().dot(normal) >= SKIN_COSINE
        ? bell(faced.heightMm() / widthMm)
        : 0;
  }

  private boolean isInside(int n, double depthMm) {
    Vec3 p = surface.points().get(n);
    SurfaceCells.Place place =
        faced.place(map.x(p.x, p.y, p.z), map.y(p.x, p.y, p.z), map.z(p.x, p.y, p.z));
    return place == SurfaceCells.Place.DEEP
        || (place == SurfaceCells.Place.NEAR && faced.heightMm() < -depthMm);
  }

  private static double bell(double off) {
    return Math.abs(off) < 1 ? 1 - off * off : 0;
  }

  /**
   * Scores a pose that may be off by some edges.
   *
   * @param near indices of points around a place where the surfaces may meet
   * @param whole indices of points of the whole surface
   * @return the score, larger for a better pose; at least 0
   */
  double roughScore(Pose pose, int[] near, int[] whole) {
    map.set(pose);
    double inside = 0;
    for (int n : whole) {
      inside += isInside(n, ROUGH_INSIDE_EDGES * edgeMm) ? 1 : 0;
      if (inside > MOST_INSIDE * whole.length) {
        return 0;
      }
    }
    double widthMm = ROUGH_EDGES * edgeMm;
    double sum = 0;
    for (int n : near) {
      sum += contact(n, widthMm) + SKIN_WEIGHT * skin(n, widthMm);
    }
    return Math.max(0, sum / near.length - INSIDE_COST * inside / whole.length);
  }

  /**
   * Scores a pose.
   *
   * @param points indices of evenly spread points of the whole surface
   * @return the area that speaks for the pose less the area against it, mm^2
   */
  double score(Pose pose, int[] points) {
    return score(pose, points, 0);
  }

  /**
   * Scores a pose that was fitted exactly: exact contact counts more than all else.
   *
   * @param points indices of evenly spread points of the whole surface
   * @return the area that speaks for the pose less the area against it, mm^2
   */
  double exactScore(Pose pose, int[] points) {
    return score(pose, points, EXACT_WEIGHT);
  }

  private double score(Pose pose, int[] points, double exactWeight) {
    map.set(pose);
    double contact = 0;
    double exact = 0;
    double skin = 0;
    double against = 0;
    for (int n : points) {
      double face = faceScore(n);
      contact += Math.max(0, face);
      against -= Math.min(0, face);
      exact += face > 0 ? touching(EXACT_EDGES) : 0;
      skin += SKIN_WEIGHT * skin(n, CONTACT_EDGES * edgeMm);
      against += isInside(n, INSIDE_EDGES * edgeMm) ? INSIDE_COST : 0;
    }
    double plain = skin + Math.min(contact, skin) - against;
    double sum = plain + (plain > 0 ? exactWeight * Math.min(exact, skin) : 0);
    return sum * surface.areaMm2() * surface.points().size() / points.length;
  }

  private double faceScore(int n) {
    if (!faces(n)) {
      return 0;
    }
    boolean isOpen =
        bell((faced.heightMm() - gapMm) / (CONTACT_EDGES * edgeMm)) == 0
            && faced.heightMm() < OPEN_EDGES * edgeMm;
    return isOpen ? -OPEN_COST : touching(CONTACT_EDGES);
  }

  /** Returns how well the point and the one that it faces touch, with normals reversed; 0 to 1. */
  private double touching(double widthEdges) {
    double unlike = (1 + faced.normal().dot(normal)) / UNLIKE;
    return bell((faced.heightMm() - gapMm) / (widthEdges * edgeMm)) * Math.max(0, 1 - unlike);
  }

  /**
   * Moves a pose so that gaps close and skins go on.
   *
   * @param pose the pose, which is moved
   * @param points indices of evenly spread points of the whole surface
   * @param widthMm the distance from which points count nothing, mm
   */
  void refine(Pose pose, int[] points, double widthMm) {
    for (int step = 0; step < STEPS; step++) {
      map.set(pose);
      pose.transform(surface.centroid(), centre);
      FitEquations equations = new FitEquations(surface.leverMm(), true);
      int pairs = 0;
      for (int n : points) {
        double weight = contact(n, widthMm);
        double residualMm = gapMm - faced.heightMm();
        if (weight == 0) {
          weight = SKIN_WEIGHT * skin(n, widthMm);
          residualMm = -faced.heightMm();
        }
        if (weight > 0) {
          equations.add(at.sub(centre, at), faced.normal(), residualMm, weight);
          pairs++;
        }
      }
      if (pairs < LEAST_PAIRS) {
        return;
      }
      equations.solve(pairs, LEAST_NOISE_EDGES * edgeMm);
      if (move(pose, equations.step()) < SMALL_STEP_EDGES * edgeMm) {
        return;
      }
    }
  }

  /** Moves a pose by a step about the centre. Returns the length of the whole step, mm. */
  private double move(Pose pose, double[] step) {
    double square = 0;
    for (double s : step) {
      square += s * s;
    }
    double length = Math.sqrt(square);
    double part = Math.min(1, STEP_EDGES * edgeMm / Math.max(length, Double.MIN_NORMAL));
    double turned = part / surface.leverMm();
    turn.setRotationVector(along.set(turned * step[3], turned * step[4], turned * step[5]));
    turn.rotate(pose.translation.sub(centre, pose.translation), pose.translation);
    pose.translation.add(centre, pose.translation);
    along.set(part * step[0], part * step[1], part * step[2]);
    pose.translation.add(along, pose.translation);
    turn.multiply(pose.rotation, pose.rotation);
    pose.rotation.normalize();
    return length;
  }
}
