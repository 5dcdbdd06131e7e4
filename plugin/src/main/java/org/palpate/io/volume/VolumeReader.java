package org.palpate.io.volume;

import java.nio.file.Path;
import java.util.List;

/**
 * One volume in a file or in several, its header understood and its sizes checked against what is
 * there. Nothing of the values is kept.
 */
public interface VolumeReader {
  /** What the file says of the volume. */
  VolumeHeader header();

  /**
   * Reads the values once, from the first slice to the last, and hands each slice to {@code sink};
   * may be called again. Takes the memory of a few slices.
   *
   * @throws VolumeFormatException where the values cannot be read; the sink has then seen some
   *     slices
   */
  void read(SliceSink sink) throws VolumeFormatException;

  /** Where it comes from, as messages name it: a path, or a phantom. */
  String sourceName();

  /**
   * Every file that holds part of the volume, in the order in which they are read; none where it
   * comes from no file.
   */
  List<Path> files();
}
