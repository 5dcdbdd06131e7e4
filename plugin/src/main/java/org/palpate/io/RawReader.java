package org.palpate.io;

import java.nio.file.Path;
import java.util.List;
import org.palpate.io.VolumeHeader.ValueRange;
import org.palpate.io.VolumeHeader.World;
import org.palpate.volume.VoxelGrid;

/** Reads a raw file, whose layout a person gives. */
final class RawReader {
  private RawReader() {}

  static VolumeReader open(Path file, RawLayout layout, ReadOptions options)
      throws VolumeFormatException {
    VoxelGrid grid =
        Grids.ofSpacing(
            new int[] {layout.sizeX(), layout.sizeY(), layout.sizeZ()}, layout.spacingMm(), file);
    VoxelType type = layout.type();
    double needed = (double) grid.voxelCount() * type.bytes();
    long length = Inputs.length(file);
    if (needed != length) {
      throw new VolumeFormatException(
          "its length is " + length + " bytes, --raw asks for " + (long) needed,
          file,
          "correct the sizes or the type of --raw");
    }
    VolumeHeader header =
        new VolumeHeader(
            "raw, as --raw says",
            grid,
            type,
            ValueRange.of(type),
            World.UNKNOWN,
            java.util.Optional.empty(),
            List.of());
    return new StreamedVolume(
        header,
        List.of(file),
        () -> new BinarySamples(Inputs.open(file, 0), type, layout.order(), Scaling.NONE),
        ExtraAxis.NONE,
        options.progress());
  }
}
