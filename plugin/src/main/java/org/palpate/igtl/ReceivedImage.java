package org.palpate.igtl;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.palpate.geometry.Vec3;

/**
 * An IMAGE message: a volume of one value a voxel, or a label map.
 *
 * @param name the device name of the message
 * @param sizeX number of voxels along the fastest axis
 * @param sizeY number of voxels along the second axis
 * @param sizeZ number of voxels along the slowest axis
 * @param stepX from a voxel centre to the next one along x, RAS, mm
 * @param stepY the same along y
 * @param stepZ the same along z
 * @param firstCentre the centre of the first voxel, RAS, mm
 * @param type the type of the values
 * @param values the values, x fastest; read-only, with its byte order set
 */
public record ReceivedImage(
    String name,
    int sizeX,
    int sizeY,
    int sizeZ,
    Vec3 stepX,
    Vec3 stepY,
    Vec3 stepZ,
    Vec3 firstCentre,
    Type type,
    ByteBuffer values) {

  /** The type of message that carries an image. */
  static final String TYPE = "IMAGE";

  private static final int HEADER_BYTES = 72;
  private static final int COORDINATES_RAS = 1;
  private static final int COORDINATES_LPS = 2;
  private static final int BIG_ENDIAN = 1;
  private static final int LITTLE_ENDIAN = 2;

  /** The longest and shortest edge of a voxel that is accepted, mm. */
  private static final double MIN_SPACING_MM = 1e-6;

  private static final double MAX_SPACING_MM = 1e6;

  /** The type of the values of an image. */
  public enum Type {
    /** Signed byte. */
    INT8(2, 1),
    /** Unsigned byte. */
    UINT8(3, 1),
    /** Signed 16 bits. */
    INT16(4, 2),
    /** Unsigned 16 bits. */
    UINT16(5, 2),
    /** Signed 32 bits. */
    INT32(6, 4),
    /** Unsigned 32 bits. */
    UINT32(7, 4),
    /** Single precision. */
    FLOAT32(10, 4),
    /** Double precision. */
    FLOAT64(11, 8);

    private final int code;
    private final int bytes;

    Type(int code, int bytes) {
      this.code = code;
      this.bytes = bytes;
    }

    private static Type of(int code) throws LinkProtocolException {
      for (Type type : values()) {
        if (type.code == code) {
          return type;
        }
      }
      throw new LinkProtocolException("an image has the unknown scalar type " + code);
    }

    /** Whether the values are whole numbers, as those of a label map. */
    public boolean isInteger() {
      return this != FLOAT32 && this != FLOAT64;
    }
  }

  /** Returns the number of voxels. */
  public int voxels() {
    return sizeX * sizeY * sizeZ;
  }

  /**
   * Returns the value of a voxel.
   *
   * @param voxel its number, x fastest, from 0
   */
  public double value(int voxel) {
    int at = voxel * type.bytes;
    return switch (type) {
      case INT8 -> values.get(at);
      case UINT8 -> values.get(at) & 0xff;
      case INT16 -> values.getShort(at);
      case UINT16 -> values.getShort(at) & 0xffff;
      case INT32 -> values.getInt(at);
      case UINT32 -> values.getInt(at) & 0xffff_ffffL;
      case FLOAT32 -> values.getFloat(at);
      case FLOAT64 -> values.getDouble(at);
    };
  }

  /**
   * Parses the content of an IMAGE message.
   *
   * @throws LinkProtocolException if it is no whole volume of one value a voxel
   */
  static ReceivedImage parse(Message message) throws LinkProtocolException {
    ByteBuffer in = message.content();
    check(in.remaining() >= HEADER_BYTES, "the header of an image is cut off");
    in.getShort(); // version of the image header; 1 and 2 have the same fields
    int components = in.get() & 0xff;
    check(components == 1, "an image has " + components + " values a voxel; send one");
    Type type = Type.of(in.get() & 0xff);
    int endian = in.get();
    check(endian == BIG_ENDIAN || endian == LITTLE_ENDIAN, "unknown byte order " + endian);
    int coordinates = in.get();
    int[] size = {unsigned(in), unsigned(in), unsigned(in)};
    Vec3[] geometry = {vector(in), vector(in), vector(in), vector(in)};
    int[] part = {
      unsigned(in), unsigned(in), unsigned(in), unsigned(in), unsigned(in), unsigned(in)
    };
    check(isWhole(size, part), "an image is part of a volume; send the whole volume");
    long bytes = (long) size[0] * size[1] * size[2] * type.bytes;
    check(bytes > 0, "an image has no voxels");
    check(bytes == in.remaining(), "an image has " + in.remaining() + " bytes instead of " + bytes);
    toRas(coordinates, geometry);
    ByteBuffer values = in.slice();
    values.order(endian == BIG_ENDIAN ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    return new ReceivedImage(
        message.header().deviceName(),
        size[0],
        size[1],
        size[2],
        geometry[0],
        geometry[1],
        geometry[2],
        firstCentre(size, geometry),
        type,
        values);
  }

  private static void check(boolean right, String fault) throws LinkProtocolException {
    if (!right) {
      throw new LinkProtocolException(fault);
    }
  }

  private static int unsigned(ByteBuffer in) {
    return in.getShort() & 0xffff;
  }

  private static Vec3 vector(ByteBuffer in) {
    return new Vec3(in.getFloat(), in.getFloat(), in.getFloat());
  }

  private static boolean isWhole(int[] size, int[] part) {
    boolean whole = true;
    for (int axis = 0; axis < 3; axis++) {
      whole &= part[axis] == 0 && part[3 + axis] == size[axis];
    }
    return whole;
  }

  /** Turns the vectors to RAS; checks that they span a volume. */
  private static void toRas(int coordinates, Vec3[] geometry) throws LinkProtocolException {
    check(
        coordinates == COORDINATES_RAS || coordinates == COORDINATES_LPS,
        "unknown coordinate system " + coordinates);
    for (Vec3 vector : geometry) {
      check(vector.isFinite(), "an image has a position that is not finite");
      if (coordinates == COORDINATES_LPS) {
        vector.set(-vector.x, -vector.y, vector.z);
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      double mm = geometry[axis].length();
      check(
          mm >= MIN_SPACING_MM && mm <= MAX_SPACING_MM,
          "an image has a spacing of " + mm + " mm along axis " + axis);
    }
  }

  /** Returns the centre of the first voxel; the message has the centre of the volume. */
  private static Vec3 firstCentre(int[] size, Vec3[] geometry) {
    Vec3 centre = new Vec3().set(geometry[3]);
    for (int axis = 0; axis < 3; axis++) {
      double steps = (size[axis] - 1) / 2.0;
      Vec3 step = geometry[axis];
      centre.set(centre.x - steps * step.x, centre.y - steps * step.y, centre.z - steps * step.z);
    }
    return centre;
  }
}
