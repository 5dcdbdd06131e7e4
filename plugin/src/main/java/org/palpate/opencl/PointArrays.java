package org.palpate.opencl;

import org.palpate.geometry.PointSet;

/** Points whose coordinates a subclass fills in. */
abstract class PointArrays implements PointSet {
  final double[] x;
  final double[] y;
  final double[] z;

  PointArrays(int count) {
    x = new double[count];
    y = new double[count];
    z = new double[count];
  }

  @Override
  public int count() {
    return x.length;
  }

  @Override
  public double x(int point) {
    return x[point];
  }

  @Override
  public double y(int point) {
    return y[point];
  }

  @Override
  public double z(int point) {
    return z[point];
  }
}
