package org.palpate.geometry;

/** Points by index, such as the sample points of a tool. They do not change. */
public interface PointSet {
  /** {@return the number of points} */
  int count();

  /**
   * {@return the x coordinate of a point}
   *
   * @param point the number of the point, from 0
   */
  double x(int point);

  /**
   * {@return the y coordinate of a point}
   *
   * @param point the number of the point, from 0
   */
  double y(int point);

  /**
   * {@return the z coordinate of a point}
   *
   * @param point the number of the point, from 0
   */
  double z(int point);
}
