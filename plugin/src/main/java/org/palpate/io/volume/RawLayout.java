package org.palpate.io.volume;

import java.nio.ByteOrder;
import java.util.Locale;
import java.util.Map;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;

/**
 * The layout of a raw file, which the file itself does not hold: {@code 256x256x113:u16be:1,1,2}.
 *
 * @param sizeX voxels along x
 * @param sizeY voxels along y
 * @param sizeZ voxels along z
 * @param type the type of a voxel
 * @param order the byte order of a voxel
 * @param spacingMm edge lengths of a voxel
 */
public record RawLayout(
    int sizeX, int sizeY, int sizeZ, VoxelType type, ByteOrder order, Vec3 spacingMm) {
  private static final String OPTION = "--raw";
  private static final Map<String, VoxelType> TYPES =
      Map.of(
          "i8", VoxelType.INT8,
          "u8", VoxelType.UINT8,
          "i16", VoxelType.INT16,
          "u16", VoxelType.UINT16,
          "i32", VoxelType.INT32,
          "u32", VoxelType.UINT32,
          "i64", VoxelType.INT64,
          "u64", VoxelType.UINT64,
          "f32", VoxelType.FLOAT32,
          "f64", VoxelType.FLOAT64);

  /**
   * Parses {@code XxYxZ:TYPE:SX,SY,SZ}. The type is i, u or f with its number of bits; a type of
   * more than 8 bits ends in {@code le} or {@code be}.
   *
   * @throws VolumeFormatException if the text has another form
   */
  public static RawLayout parse(String text) throws VolumeFormatException {
    String[] parts = text.strip().split(":", -1);
    if (parts.length != 3) {
      throw refusal("the layout does not have three parts", text);
    }
    int[] sizes = sizes(parts[0], text);
    return new RawLayout(
        sizes[0],
        sizes[1],
        sizes[2],
        type(parts[1], text),
        order(parts[1]),
        spacing(parts[2], text));
  }

  private static int[] sizes(String part, String text) throws VolumeFormatException {
    String[] words = part.split("x", -1);
    int[] sizes = new int[3];
    for (int axis = 0; axis < 3; axis++) {
      sizes[axis] = words.length == 3 ? NumberParser.positiveInt(words[axis]) : 0;
      if (sizes[axis] < 1) {
        throw refusal("sizes must be three integers from 1 to 2147483647", text);
      }
    }
    return sizes;
  }

  private static VoxelType type(String part, String text) throws VolumeFormatException {
    String name = part.toLowerCase(Locale.ROOT).replaceFirst("[lb]e$", "");
    VoxelType type = TYPES.get(name);
    if (type == null || (type.bytes() > 1 && name.length() == part.length())) {
      throw refusal("the type '" + part + "' is unknown or has no byte order", text);
    }
    return type;
  }

  private static ByteOrder order(String part) {
    return part.toLowerCase(Locale.ROOT).endsWith("be")
        ? ByteOrder.BIG_ENDIAN
        : ByteOrder.LITTLE_ENDIAN;
  }

  private static Vec3 spacing(String part, String text) throws VolumeFormatException {
    String[] words = part.split(",", -1);
    Vec3 spacing = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      double value = words.length == 3 ? NumberParser.number(words[axis]) : Double.NaN;
      if (!(value > 0) || Double.isInfinite(value)) {
        throw refusal("the spacing must be three positive numbers in mm", text);
      }
      spacing.set(axis, value);
    }
    return spacing;
  }

  private static VolumeFormatException refusal(String what, String text) {
    return new VolumeFormatException(
        what,
        OPTION + " " + text,
        "write it as 256x256x113:u16be:1,1,2 (types i8 u8 i16 u16 i32 u32 i64 u64 f32 f64, le or"
            + " be)");
  }
}
