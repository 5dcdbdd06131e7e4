package org.palpate.app.options;

import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.fracture.PartialVoxels;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.file.NumberParser;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine.Option;

/** The option of a scan whose grey values show a guide to a fit where faces lie. */
public final class FitGreyOption {
  private static final String NAME = "--fit-grey";
  private static final String RULE = ":>=";

  @Option(
      names = NAME,
      paramLabel = "FILE:>=VALUE",
      description =
          "With --guide fit: the scan from which the fragments were made, and the threshold. Its"
              + " grey values then show where faces lie between voxels.")
  private String scan;

  /**
   * Checks the form, before a volume is read.
   *
   * @param hasFit whether there is a guide to a fit
   * @throws PalpateException exit code 2, if the option is wrong
   */
  public void check(boolean hasFit) {
    if (scan != null) {
      file();
      threshold();
      if (!hasFit) {
        throw PalpateException.wrongUse(
            "grey values of a fit need a fit", NAME + " " + scan, "add --guide fit");
      }
    }
  }

  /**
   * Returns every file of the scan, which no output may replace.
   *
   * @throws VolumeFormatException if the scan cannot be read
   */
  public List<Path> files() throws VolumeFormatException {
    return scan == null ? List.of() : open().files();
  }

  private VolumeReader open() throws VolumeFormatException {
    return VolumeFiles.open(file(), ReadOptions.defaults());
  }

  private Path file() {
    int end = scan.lastIndexOf(RULE);
    try {
      if (end > 0) {
        return Path.of(scan.substring(0, end));
      }
    } catch (InvalidPathException e) {
      throw notUnderstood(e);
    }
    throw notUnderstood(null);
  }

  private double threshold() {
    double value = NumberParser.number(scan.substring(scan.lastIndexOf(RULE) + RULE.length()));
    if (!Double.isFinite(value)) {
      throw notUnderstood(null);
    }
    return value;
  }

  private PalpateException notUnderstood(Throwable cause) {
    return PalpateException.wrongUse(
        "the grey values of a fit cannot be read",
        NAME + " " + scan,
        "write a file and a threshold, as in 'chin.nrrd:>=1500'",
        cause);
  }

  /**
   * Returns how full the voxels at the surface of each fragment are; empty for each without the
   * option, and for a fragment whose voxels are not those of the scan.
   *
   * @param fragments the fragments where they rest
   * @param world the directions of the world axes
   * @param err receives a note if the axes of the scan cannot be turned into these
   * @throws VolumeFormatException if the scan cannot be read
   * @throws PalpateException exit code 2, if no fragment has the voxels of the scan
   */
  public List<Optional<PartialVoxels>> partialVoxels(
      SegmentedVolume fragments, CoordinateSystem world, PrintWriter err)
      throws VolumeFormatException {
    int count = fragments.segments().size();
    if (scan == null) {
      return Collections.nCopies(count, Optional.empty());
    }
    VolumeReader reader = open();
    VoxelGrid own = reader.header().grid();
    Optional<VoxelGrid> turned = AxisSigns.convert(own, reader.header().coordinateSystem(), world);
    if (turned.isEmpty()) {
      err.println(BodyReader.unknownAxes(reader.sourceName()));
      err.flush();
    }
    VoxelGrid grid = turned.orElse(own);
    ScalarVolume values = GreyVolumes.read(reader);
    double threshold = threshold();
    double contrast = GreyIsosurface.ofThreshold(values, threshold).contrast();
    List<Optional<PartialVoxels>> partial = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      BitCube bits = fragments.segments().get(n).bits();
      partial.add(PartialVoxels.of(bits, fragments.grid(n), values, grid, threshold, contrast));
    }
    if (partial.stream().allMatch(Optional::isEmpty)) {
      throw PalpateException.wrongUse(
          "no body has the voxels of the scan",
          NAME + " " + scan,
          "choose the scan from which the fragments were made, cropped and resampled as it was");
    }
    return partial;
  }
}
