package org.palpate.igtl;

import java.nio.ByteBuffer;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A TRANSFORM message: a named pose.
 *
 * @param name the device name of the message, at most 20 characters
 * @param pose RAS, mm; its axes are orthonormal and right-handed, up to the rounding of floats
 */
public record ReceivedTransform(String name, RigidTransform pose) {

  /** The type of message that carries a transform. */
  static final String TYPE = "TRANSFORM";

  /** The size of the content: the rotation by columns, then the translation, as floats. */
  static final int BYTES = 48;

  /**
   * Parses the content of a TRANSFORM message.
   *
   * @throws LinkProtocolException if it is no rigid motion
   */
  static ReceivedTransform parse(Message message) throws LinkProtocolException {
    ByteBuffer in = message.content();
    if (in.remaining() != BYTES) {
      throw new LinkProtocolException(
          "a transform has " + in.remaining() + " bytes instead of " + BYTES);
    }
    RigidTransform pose = new RigidTransform(vector(in), vector(in), vector(in), vector(in));
    if (!pose.origin().isFinite() || !pose.isOrthonormal() || pose.isMirrored()) {
      throw new LinkProtocolException(
          "a transform is no rigid motion; send one without scale, shear and reflection");
    }
    return new ReceivedTransform(message.header().deviceName(), pose);
  }

  private static Vec3 vector(ByteBuffer in) {
    return new Vec3(in.getFloat(), in.getFloat(), in.getFloat());
  }
}
