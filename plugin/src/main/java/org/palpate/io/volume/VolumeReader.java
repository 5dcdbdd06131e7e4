package org.palpate.io.volume;

import java.nio.file.Path;
import java.util.List;

/**
 * Reads one volume from one or several files. The header is parsed and its sizes are checked
 * against the files; no voxel is kept.
 */
public interface VolumeReader {
  /** Returns the header of the volume. */
  VolumeHeader header();

  /**
   * Reads all slices in order and hands each to {@code sink}. May be called again. Needs the memory
   * of a few slices.
   *
   * @throws VolumeFormatException if the voxels cannot be read; the sink has then received some
   *     slices
   */
  void read(SliceSink sink) throws VolumeFormatException;

  /**
   * Reads all slices as {@link #read} does, but hands a slice over once for each layer of labels
   * that overlap. Each label has the same value in every layer, and 0 is empty. Without overlap
   * there is a single layer.
   *
   * @throws VolumeFormatException if the voxels cannot be read
   */
  default void readLayers(SliceSink sink) throws VolumeFormatException {
    read(sink);
  }

  /** Returns the source as messages name it: a path or a phantom. */
  String sourceName();

  /**
   * Returns every file that holds part of the volume, in reading order; empty if there is no file.
   */
  List<Path> files();
}
