package org.palpate.scene;

import java.util.Arrays;
import org.palpate.geometry.RigidTransform;
import org.palpate.scene.SlicePlanes.Grey;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * The grey values of a volume with the contrast of its slices. The darkest and the brightest
 * hundredth of the voxels are drawn black and white.
 *
 * <p>Immutable except for the volume; any thread.
 */
public final class GreySlices implements Grey {
  private static final int SAMPLES_PER_AXIS = 48;
  private static final double TAIL_FRACTION = 0.01;

  private final ScalarVolume volume;
  private final double black;
  private final double white;

  private GreySlices(ScalarVolume volume, double black, double white) {
    this.volume = volume;
    this.black = black;
    this.white = white;
  }

  /** Returns the same values with another contrast; {@code white} lies above {@code black}. */
  GreySlices withContrast(double newBlack, double newWhite) {
    return new GreySlices(volume, newBlack, newWhite);
  }

  /** Measures the contrast on a regular sample of the values. */
  public GreySlices(ScalarVolume volume) {
    this.volume = volume;
    double[] sample = sample();
    int tail = (int) (sample.length * TAIL_FRACTION);
    black = sample.length == 0 ? 0 : sample[tail];
    double high = sample.length == 0 ? 0 : sample[sample.length - 1 - tail];
    white = high > black ? high : black + 1;
  }

  private double[] sample() {
    int stepX = step(0);
    int stepY = step(1);
    int stepZ = step(2);
    double[] values = new double[8 * SAMPLES_PER_AXIS * SAMPLES_PER_AXIS * SAMPLES_PER_AXIS];
    int count = 0;
    for (int k = 0; k < size(2); k += stepZ) {
      for (int j = 0; j < size(1); j += stepY) {
        for (int i = 0; i < size(0); i += stepX) {
          double value = volume.value(i, j, k);
          if (Double.isFinite(value)) {
            values[count++] = value;
          }
        }
      }
    }
    double[] sorted = Arrays.copyOf(values, count);
    Arrays.sort(sorted);
    return sorted;
  }

  private int step(int axis) {
    return Math.max(1, size(axis) / SAMPLES_PER_AXIS);
  }

  /**
   * Returns the planes through a voxel in the scene of a model.
   *
   * @param i number of the plane across x, -1 for none; j and k likewise
   */
  public SlicePlanes through(int i, int j, int k, SceneModel model) {
    VoxelGrid grid = volume.grid();
    RigidTransform pose = model.axes().toScene(grid.gridMmToWorld());
    return new SlicePlanes(this, i, j, k, grid.spacingMm(), pose);
  }

  @Override
  public int size(int axis) {
    VoxelGrid grid = volume.grid();
    return axis == 0 ? grid.sizeX() : axis == 1 ? grid.sizeY() : grid.sizeZ();
  }

  @Override
  public double value(int i, int j, int k) {
    return volume.value(i, j, k);
  }

  @Override
  public double black() {
    return black;
  }

  @Override
  public double white() {
    return white;
  }
}
