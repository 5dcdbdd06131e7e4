package org.palpate.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;

/** Computes the SHA-256 by which a report identifies its volume. */
public final class VolumeDigest {
  private VolumeDigest() {}

  /**
   * Returns the hexadecimal SHA-256 of all files of a volume in reading order. A volume without
   * files is hashed as its values, little-endian 32-bit integers. Reads everything once.
   */
  public static String sha256(VolumeReader reader) throws IOException {
    MessageDigest digest = newDigest();
    if (reader.files().isEmpty()) {
      reader.read((k, slice) -> update(digest, slice));
    }
    for (Path file : reader.files()) {
      update(digest, file);
    }
    return HexFormat.of().formatHex(digest.digest());
  }

  private static MessageDigest newDigest() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("no SHA-256, which every Java platform has", e);
    }
  }

  private static void update(MessageDigest digest, VoxelSlice slice) {
    byte[] bytes = new byte[4 * slice.count()];
    for (int n = 0; n < slice.count(); n++) {
      int value = slice.integers()[n];
      for (int b = 0; b < 4; b++) {
        bytes[4 * n + b] = (byte) (value >> (8 * b));
      }
    }
    digest.update(bytes);
  }

  private static void update(MessageDigest digest, Path file) throws IOException {
    byte[] buffer = new byte[1 << 16];
    try (InputStream in = Files.newInputStream(file)) {
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        digest.update(buffer, 0, n);
      }
    }
  }
}
