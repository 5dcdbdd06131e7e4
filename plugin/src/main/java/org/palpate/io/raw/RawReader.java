package org.palpate.io.raw;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.Grids;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.format.Scaling;
import org.palpate.io.format.SliceFiles;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/** Reads a raw file, or a folder of raw slices, with a layout that the user gives. */
public final class RawReader {
  private RawReader() {}

  /**
   * Opens a file or folder.
   *
   * @throws VolumeFormatException if its length is not that of the layout
   */
  public static VolumeReader open(Path file, RawLayout layout, ReadOptions options)
      throws VolumeFormatException {
    ReadOptionChecks.chosenStep(1, options, file, new ArrayList<>());
    VoxelGrid grid =
        Grids.ofSpacing(
            new int[] {layout.sizeX(), layout.sizeY(), layout.sizeZ()}, layout.spacingMm(), file);
    VoxelType type = layout.type();
    List<Path> files = Files.isDirectory(file) ? SliceFiles.of(file) : List.of(file);
    double needed = (double) grid.voxelCount() * type.bytes();
    long length = 0;
    for (Path part : files) {
      length += InputFiles.length(part);
    }
    if (needed != length) {
      throw new VolumeFormatException(
          "the file has "
              + length
              + " bytes"
              + (files.size() > 1 ? " in " + files.size() + " files" : "")
              + " but --raw describes "
              + (long) needed,
          file,
          "correct the sizes or the type of --raw");
    }
    VolumeHeader header =
        new VolumeHeader(
            "raw, as --raw says",
            grid,
            type,
            ValueRange.of(type),
            CoordinateSystem.UNKNOWN,
            Optional.empty(),
            List.of());
    BinaryData data =
        new BinaryData(
            files,
            new BinaryData.Start(0, false, false),
            type,
            layout.order(),
            Scaling.NONE,
            length);
    data.requireFileLengths();
    return new StreamVolumeReader(header, files, data, NonSpatialAxis.NONE, options.progress());
  }
}
