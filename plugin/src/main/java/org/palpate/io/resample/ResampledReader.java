package org.palpate.io.resample;

import java.nio.file.Path;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Reads a volume on another grid. Labels come from the voxel that holds the centre of the new one.
 * Grey values are interpolated linearly between voxel centres; integers stay integers. Beyond the
 * source, labels are 0 and grey values those of its nearest voxels.
 */
public final class ResampledReader implements VolumeReader {
  private final VolumeReader source;
  private final Resampling resampling;
  private final boolean isLabels;
  private ScalarVolume values;

  /**
   * Creates a reader.
   *
   * @param isLabels whether values are labels, which must not be interpolated
   */
  public ResampledReader(VolumeReader source, Resampling resampling, boolean isLabels) {
    this.source = source;
    this.resampling = resampling;
    this.isLabels = isLabels;
  }

  @Override
  public VolumeHeader header() {
    VolumeHeader h = source.header();
    return new VolumeHeader(
        h.format(),
        resampling.grid(),
        h.type(),
        h.values(),
        h.coordinateSystem(),
        h.labels(),
        h.notes());
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    if (values == null) {
      values = GreyVolumes.read(source);
    }
    VoxelGrid grid = resampling.grid();
    boolean isInteger = header().values().isInteger();
    VoxelSlice slice = MemoryCheck.slice(grid, isInteger, sourceName());
    Vec3 p = new Vec3();
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          resampling.toSource().transform(p.set(i + 0.5, j + 0.5, k + 0.5), p);
          double value = isLabels ? nearest(p) : linear(p);
          int at = j * grid.sizeX() + i;
          if (isInteger) {
            slice.integers()[at] = (int) Math.rint(value);
          } else {
            slice.doubles()[at] = value;
          }
        }
      }
      sink.accept(k, slice);
    }
  }

  private double nearest(Vec3 p) {
    int i = (int) Math.floor(p.x);
    int j = (int) Math.floor(p.y);
    int k = (int) Math.floor(p.z);
    return values.grid().contains(i, j, k) ? values.value(i, j, k) : 0;
  }

  private double linear(Vec3 p) {
    VoxelGrid grid = values.grid();
    double x = clamped(p.x - 0.5, grid.sizeX());
    double y = clamped(p.y - 0.5, grid.sizeY());
    double z = clamped(p.z - 0.5, grid.sizeZ());
    double sum = 0;
    for (int corner = 0; corner < 8; corner++) {
      int i = (int) x + (corner & 1);
      int j = (int) y + (corner >> 1 & 1);
      int k = (int) z + (corner >> 2);
      double weight = weight(x, i) * weight(y, j) * weight(z, k);
      sum += weight == 0 ? 0 : weight * values.value(i, j, k);
    }
    return sum;
  }

  private static double clamped(double coordinate, int size) {
    return Math.max(0, Math.min(size - 1, coordinate));
  }

  private static double weight(double coordinate, int voxel) {
    return Math.max(0, 1 - Math.abs(coordinate - voxel));
  }

  @Override
  public String sourceName() {
    return source.sourceName();
  }

  @Override
  public List<Path> files() {
    return source.files();
  }
}
