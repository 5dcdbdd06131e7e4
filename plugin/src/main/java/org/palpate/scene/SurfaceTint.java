package org.palpate.scene;

import java.nio.ByteBuffer;
import java.util.List;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;

/**
 * Colours a part of a surface by a measured value, from purple for 0 through blue and green to
 * yellow for 1. Values are known at some points alone, so each cell of a grid also holds a cover:
 * how well the points around it determine its value. Without cover the surface keeps its colour.
 *
 * <p>Immutable; nobody writes to its parts. The colours are those of the map viridis, which people
 * with impaired colour vision can read.
 */
public final class SurfaceTint {
  /** The number of cells on each side of a point to which its value spreads. */
  private static final int REACH = 2;

  private static final int FULL = 255;

  /** The cover from which on a colour is full; a single point gives that much at its own cell. */
  private static final double FULL_COVER = 0.5;

  private final Vec3 lowMm;
  private final Vec3 cellMm;
  private final int[] sizes;
  private final byte[] cells;

  private SurfaceTint(Vec3 lowMm, Vec3 cellMm, int[] sizes, byte[] cells) {
    this.lowMm = lowMm;
    this.cellMm = cellMm;
    this.sizes = sizes;
    this.cells = cells;
  }

  /** Returns the low corner of the cells, grid mm. */
  public Vec3 lowMm() {
    return lowMm;
  }

  /** Returns the edges of a cell, mm. */
  public Vec3 cellMm() {
    return cellMm;
  }

  /** Returns the number of cells along an axis. */
  public int size(int axis) {
    return sizes[axis];
  }

  /** Returns two bytes for each cell, x first: value times cover, and cover, up to 255. */
  public ByteBuffer cells() {
    return ByteBuffer.wrap(cells).asReadOnlyBuffer();
  }

  /**
   * A value at a point of a surface.
   *
   * @param grid the point in grid coordinates
   * @param value 0 to 1
   */
  public record Sample(Vec3 grid, double value) {}

  /**
   * Makes a tint of samples, each of which spreads over about two voxels.
   *
   * @param samples at least one
   * @param spacingMm the edges of a voxel
   */
  public static SurfaceTint of(List<Sample> samples, Vec3 spacingMm) {
    IntBox box = new IntBox();
    for (Sample each : samples) {
      int i = (int) Math.floor(each.grid.x);
      int j = (int) Math.floor(each.grid.y);
      int k = (int) Math.floor(each.grid.z);
      box.include(i - REACH, j - REACH, k - REACH);
      box.include(i + REACH, j + REACH, k + REACH);
    }
    int sizeX = box.highX - box.lowX + 1;
    int sizeY = box.highY - box.lowY + 1;
    int sizeZ = box.highZ - box.lowZ + 1;
    float[] values = new float[sizeX * sizeY * sizeZ];
    float[] covers = new float[values.length];
    for (Sample each : samples) {
      spread(each, box, values, covers);
    }
    Vec3 low = new Vec3(box.lowX * spacingMm.x, box.lowY * spacingMm.y, box.lowZ * spacingMm.z);
    int[] sizes = {sizeX, sizeY, sizeZ};
    return new SurfaceTint(low, spacingMm, sizes, bytes(values, covers));
  }

  private static void spread(Sample sample, IntBox box, float[] values, float[] covers) {
    int i = (int) Math.floor(sample.grid.x);
    int j = (int) Math.floor(sample.grid.y);
    int k = (int) Math.floor(sample.grid.z);
    int sizeX = box.highX - box.lowX + 1;
    int sizeY = box.highY - box.lowY + 1;
    for (int z = k - REACH; z <= k + REACH; z++) {
      for (int y = j - REACH; y <= j + REACH; y++) {
        for (int x = i - REACH; x <= i + REACH; x++) {
          double dx = x + 0.5 - sample.grid.x;
          double dy = y + 0.5 - sample.grid.y;
          double dz = z + 0.5 - sample.grid.z;
          float weight = (float) Math.exp(-(dx * dx + dy * dy + dz * dz));
          int cell = ((z - box.lowZ) * sizeY + y - box.lowY) * sizeX + x - box.lowX;
          values[cell] += (float) (weight * sample.value);
          covers[cell] += weight;
        }
      }
    }
  }

  private static byte[] bytes(float[] values, float[] covers) {
    byte[] bytes = new byte[2 * values.length];
    for (int cell = 0; cell < values.length; cell++) {
      double cover = Math.min(1, covers[cell] / FULL_COVER);
      double value = covers[cell] > 0 ? values[cell] / covers[cell] : 0;
      bytes[2 * cell] = (byte) Math.round(FULL * cover * value);
      bytes[2 * cell + 1] = (byte) Math.round(FULL * cover);
    }
    return bytes;
  }
}
