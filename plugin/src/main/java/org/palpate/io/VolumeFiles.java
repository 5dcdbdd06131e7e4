package org.palpate.io;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Finds out what format a file has, and opens it. */
public final class VolumeFiles {
  private static final int START_BYTES = 1024;

  private VolumeFiles() {}

  /**
   * Opens a volume: understands its header and checks its sizes against what is there. Costs next
   * to nothing, whatever the header claims.
   *
   * @throws VolumeFormatException where it is no volume, is damaged, or needs to be told more
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    if (options.raw().isPresent()) {
      return RawReader.open(file, options.raw().get(), options);
    }
    if (Inputs.length(file) == 0) {
      throw new VolumeFormatException("it is empty", file, "copy or export it again");
    }
    byte[] start = Inputs.start(file, START_BYTES);
    if (startsWith(start, NrrdHeader.MAGIC)) {
      return NrrdReader.open(file, options);
    }
    throw new VolumeFormatException(
        "it is in no format that is known",
        file,
        "give NRRD, NIfTI, MetaImage, TIFF or DICOM, or say with --raw what a raw file holds");
  }

  private static boolean startsWith(byte[] start, String text) {
    return new String(start, StandardCharsets.ISO_8859_1).startsWith(text);
  }
}
