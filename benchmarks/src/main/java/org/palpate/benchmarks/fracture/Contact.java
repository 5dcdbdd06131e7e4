package org.palpate.benchmarks.fracture;

import org.palpate.body.BodyScene;
import org.palpate.rigid.MovableShapes;

/** The kind of a fracture, and of the contact between its fragments. */
enum Contact {
  /** A saw took a voxel away, and sample points keep out of voxels. */
  KERF(1, "kerf 1, points"),

  /** The fracture surfaces fit, and sample points keep out of voxels. */
  POINTS(0, "kerf 0, points"),

  /** The fracture surfaces fit, and whole bodies may overlap by half a voxel. */
  MARGIN(0, "kerf 0, margin -0.5 voxel");

  private static final double MARGIN_MM = -0.5;

  private final int kerfVoxels;
  private final String text;

  Contact(int kerfVoxels, String text) {
    this.kerfVoxels = kerfVoxels;
    this.text = text;
  }

  /** Returns the voxels that a saw takes away between two fragments. */
  int kerfVoxels() {
    return kerfVoxels;
  }

  /** Returns the sample points of fragments of voxels of 1 mm. */
  MovableShapes shapes(BodyScene bodies) {
    return this == MARGIN
        ? MovableShapes.ofWholeBodies(bodies, MARGIN_MM)
        : MovableShapes.ofPoints(bodies);
  }

  @Override
  public String toString() {
    return text;
  }
}
