package org.palpate.io.nifti;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.palpate.geometry.Vec3;
import org.palpate.io.format.Grids;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/**
 * Writes the header of a single-file NIfTI with RAS coordinates. The header is NIfTI-1, which every
 * program reads, if the sizes fit and its single precision moves no voxel by more than a thousandth
 * of a voxel. Otherwise it is NIfTI-2.
 */
public final class NiftiHeaderWriter {
  private static final double MAX_SHIFT_VOXELS = 1e-3;
  private static final int LABEL_INTENT = 1002;
  private static final int MILLIMETRES = 2;
  private static final int SCANNER = 1;
  private static final int ALIGNED = 2;

  private NiftiHeaderWriter() {}

  /** Returns the bytes of the header, up to the data. */
  public static byte[] of(VolumeHeader header, VoxelType type) {
    double[] affine = affine(header);
    return reasonForSecond(header.grid(), affine).isEmpty()
        ? first(header, type, affine)
        : second(header, type, affine);
  }

  /** Returns the version that {@link #of} writes, with the reason if it is NIfTI-2. */
  public static String formatName(VolumeHeader header) {
    String reason = reasonForSecond(header.grid(), affine(header));
    return reason.isEmpty()
        ? "NIfTI-1"
        : "NIfTI-2, because " + reason + "; some programs read NIfTI-1 alone";
  }

  private static String reasonForSecond(VoxelGrid grid, double[] affine) {
    if (Math.max(grid.sizeX(), Math.max(grid.sizeY(), grid.sizeZ())) > Short.MAX_VALUE) {
      return "a size is above 32,767";
    }
    double least = Math.min(grid.spacingMm().x, Math.min(grid.spacingMm().y, grid.spacingMm().z));
    return largestShiftMm(grid, affine) <= MAX_SHIFT_VOXELS * least
        ? ""
        : "single precision moves voxels";
  }

  /** Returns how far single precision moves the centre of any voxel, mm. */
  private static double largestShiftMm(VoxelGrid grid, double[] affine) {
    double[] last = {grid.sizeX() - 1.0, grid.sizeY() - 1.0, grid.sizeZ() - 1.0, 1};
    double sum = 0;
    for (int row = 0; row < 3; row++) {
      double shift = 0;
      for (int column = 0; column < 4; column++) {
        double number = affine[4 * row + column];
        shift += Math.abs((float) number - number) * last[column];
      }
      sum += shift * shift;
    }
    return Math.sqrt(sum);
  }

  /** Returns the rows of the matrix from voxel indices to RAS. */
  private static double[] affine(VolumeHeader header) {
    VoxelGrid grid = header.grid();
    Vec3 centre = grid.gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    double signX =
        switch (header.coordinateSystem()) {
          case LPS, LAS -> -1;
          case RAS, UNKNOWN -> 1;
        };
    double signY = header.coordinateSystem() == CoordinateSystem.LPS ? -1 : 1;
    double[] sign = {signX, signY, 1};
    double[] affine = new double[12];
    for (int row = 0; row < 3; row++) {
      for (int axis = 0; axis < 3; axis++) {
        affine[4 * row + axis] = sign[row] * Grids.stepMm(grid, axis).get(row) + 0.0;
      }
      affine[4 * row + 3] = sign[row] * centre.get(row) + 0.0;
    }
    return affine;
  }

  private static byte[] first(VolumeHeader header, VoxelType type, double[] affine) {
    VoxelGrid grid = header.grid();
    ByteBuffer bytes = ByteBuffer.allocate(352).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(0, 348);
    short[] dim = {3, (short) grid.sizeX(), (short) grid.sizeY(), (short) grid.sizeZ(), 1, 1, 1, 1};
    for (int n = 0; n < dim.length; n++) {
      bytes.putShort(40 + 2 * n, dim[n]);
      bytes.putFloat(76 + 4 * n, n >= 1 && n <= 3 ? (float) grid.spacingMm().get(n - 1) : 1);
    }
    bytes.putShort(68, (short) (header.labels().isPresent() ? LABEL_INTENT : 0));
    bytes.putShort(70, (short) datatype(type));
    bytes.putShort(72, (short) (8 * type.bytes()));
    bytes.putFloat(108, 352);
    bytes.putFloat(112, 1);
    bytes.put(123, (byte) MILLIMETRES);
    bytes.putShort(254, (short) sformCode(header));
    for (int n = 0; n < affine.length; n++) {
      bytes.putFloat(280 + 4 * n, (float) affine[n]);
    }
    bytes.put(344, "n+1\0".getBytes(StandardCharsets.ISO_8859_1));
    return bytes.array();
  }

  private static byte[] second(VolumeHeader header, VoxelType type, double[] affine) {
    VoxelGrid grid = header.grid();
    ByteBuffer bytes = ByteBuffer.allocate(544).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(0, 540);
    bytes.put(4, "n+2\0\r\n\032\n".getBytes(StandardCharsets.ISO_8859_1));
    bytes.putShort(12, (short) datatype(type));
    bytes.putShort(14, (short) (8 * type.bytes()));
    long[] dim = {3, grid.sizeX(), grid.sizeY(), grid.sizeZ(), 1, 1, 1, 1};
    for (int n = 0; n < dim.length; n++) {
      bytes.putLong(16 + 8 * n, dim[n]);
      bytes.putDouble(104 + 8 * n, n >= 1 && n <= 3 ? grid.spacingMm().get(n - 1) : 1);
    }
    bytes.putLong(168, 544);
    bytes.putDouble(176, 1);
    bytes.putInt(348, sformCode(header));
    for (int n = 0; n < affine.length; n++) {
      bytes.putDouble(400 + 8 * n, affine[n]);
    }
    bytes.putInt(500, MILLIMETRES);
    bytes.putInt(504, header.labels().isPresent() ? LABEL_INTENT : 0);
    return bytes.array();
  }

  private static int sformCode(VolumeHeader header) {
    return header.coordinateSystem() == CoordinateSystem.UNKNOWN ? ALIGNED : SCANNER;
  }

  private static int datatype(VoxelType type) {
    return switch (type) {
      case UINT8 -> 2;
      case INT16 -> 4;
      case INT32 -> 8;
      case FLOAT32 -> 16;
      case FLOAT64 -> 64;
      case INT8 -> 256;
      case UINT16 -> 512;
      case UINT32 -> 768;
      case INT64 -> 1024;
      case UINT64 -> 1280;
    };
  }
}
