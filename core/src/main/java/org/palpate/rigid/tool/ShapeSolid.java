package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/**
 * The solid of a tool that is a shape.
 *
 * @param shape in its own frame
 * @param referenceMm the reference point of the tool in that frame
 */
record ShapeSolid(ToolShape shape, Vec3 referenceMm) implements ToolSolid {
  @Override
  public boolean contains(double x, double y, double z) {
    return shape.contains(x + referenceMm.x, y + referenceMm.y, z + referenceMm.z);
  }

  @Override
  public Vec3 lowestNear(Vec3 sample, Vec3 up, double withinMm, Vec3 dest) {
    double x = sample.x;
    double y = sample.y;
    double z = sample.z;
    sample.add(referenceMm, dest);
    double shapeX = dest.x;
    double shapeY = dest.y;
    double shapeZ = dest.z;
    shape.lowestNear(dest, up, withinMm, dest);
    boolean isSample = dest.x == shapeX && dest.y == shapeY && dest.z == shapeZ;
    // The difference of a sum may have other bits.
    return isSample ? dest.set(x, y, z) : dest.sub(referenceMm, dest);
  }
}
