package org.palpate.geometry;

/** Points by index, such as the sample points of a tool. They do not change. */
public interface PointSet {
  /** Returns the number of points. */
  int count();

  /** Returns the x coordinate of a point. */
  double x(int point);

  /** Returns the y coordinate of a point. */
  double y(int point);

  /** Returns the z coordinate of a point. */
  double z(int point);
}
