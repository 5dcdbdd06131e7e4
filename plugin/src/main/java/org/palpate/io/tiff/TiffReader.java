package org.palpate.io.tiff;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.Grids;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.format.Scaling;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.VoxelGrid;

/**
 * Reads TIFF stacks, one page a slice. Understands the spacing, calibration, time frames and
 * channels of ImageJ, and its large stacks with a single page.
 *
 * <p>Source: TIFF Revision 6.0; ImageJ's description tag as its TiffEncoder writes it.
 */
public final class TiffReader implements VolumeReader {
  private final TiffFile tiff;
  private final ReadOptions options;
  private final List<String> notes = new ArrayList<>();
  private final List<TiffPage> slices = new ArrayList<>();
  private final VolumeHeader header;
  private final Scaling scaling;

  private TiffReader(TiffFile tiff, ReadOptions options) throws VolumeFormatException {
    this.tiff = tiff;
    this.options = options;
    List<TiffPage> pages = new ArrayList<>();
    for (Map<Integer, double[]> tags : tiff.pages()) {
      TiffPage page = new TiffPage(tiff, tags);
      if (!page.isReduced()) {
        pages.add(page);
      }
    }
    if (pages.isEmpty()) {
      throw new VolumeFormatException("the file has no page", tiff.file(), "save the stack again");
    }
    TiffPage first = pages.get(0);
    first.check();
    ImagejDescription imagej = ImagejDescription.of(first.description());
    chooseSlices(pages, imagej);
    for (TiffPage slice : slices) {
      requireSamePixels(first, slice);
    }
    scaling = imagej.scaling();
    header = header(first, imagej);
  }

  /** Returns whether a file with these first bytes is a TIFF file. */
  public static boolean accepts(byte[] start, Path file) {
    return TiffFile.isTiff(start);
  }

  /**
   * Opens a stack.
   *
   * @throws VolumeFormatException if the file is damaged, cannot be decoded, or needs another
   *     option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    TiffReader reader = new TiffReader(TiffFile.read(file), options);
    return reader.isContiguousStack() ? reader.contiguousStack() : reader;
  }

  private void chooseSlices(List<TiffPage> pages, ImagejDescription imagej)
      throws VolumeFormatException {
    int told = imagej.channels() * imagej.frames();
    int extra = told > 1 && pages.size() % told == 0 ? told : 1;
    int step = ReadOptionChecks.chosenStep(extra, options, tiff.file(), notes);
    int depth = pages.size() / extra;
    int channels = extra == 1 ? 1 : imagej.channels();
    int frame = step / channels;
    int channel = step % channels;
    for (int k = 0; k < depth; k++) {
      slices.add(pages.get((frame * depth + k) * channels + channel));
    }
  }

  private void requireSamePixels(TiffPage first, TiffPage page) throws VolumeFormatException {
    page.check();
    if (page.width() != first.width()
        || page.height() != first.height()
        || page.type() != first.type()) {
      throw page.refusal("the pages differ in size or type");
    }
  }

  private VolumeHeader header(TiffPage first, ImagejDescription imagej)
      throws VolumeFormatException {
    int depth = Math.max(slices.size(), contiguousSliceCount(first, imagej));
    VoxelGrid grid =
        Grids.ofSpacing(
            new int[] {first.width(), first.height(), depth}, spacing(first, imagej), tiff.file());
    return new VolumeHeader(
        "TIFF" + (imagej.isImagej() ? " of ImageJ" : "") + ", " + compressionName(first),
        grid,
        first.type(),
        scaling.range(first.type()),
        CoordinateSystem.UNKNOWN,
        Optional.empty(),
        notes);
  }

  /** Returns the number of slices that ImageJ stored after its only page, or 1. */
  private int contiguousSliceCount(TiffPage first, ImagejDescription imagej)
      throws VolumeFormatException {
    boolean stacked =
        slices.size() == 1 && imagej.images() > 1 && first.compression() == 1 && !first.isTiled();
    if (!stacked) {
      return 1;
    }
    if (imagej.channels() * imagej.frames() > 1) {
      throw first.refusal("the file is a hyperstack without pages");
    }
    double sliceBytes = (double) first.width() * first.height() * first.type().bytes();
    double found = Math.floor((tiff.length() - first.offsets()[0]) / sliceBytes);
    if (imagej.images() > found) {
      throw new VolumeFormatException(
          "the description promises "
              + imagej.images()
              + " slices but the file has room for at most "
              + NumberText.display(found),
          tiff.file(),
          "copy the file again; if that does not help, export it again");
    }
    return imagej.images();
  }

  private boolean isContiguousStack() {
    return header.grid().sizeZ() > slices.size();
  }

  private VolumeReader contiguousStack() throws VolumeFormatException {
    TiffPage first = slices.get(0);
    BinaryData data =
        new BinaryData(
            files(),
            new BinaryData.Start((long) first.offsets()[0], false, false),
            first.type(),
            tiff.order(),
            scaling,
            header.grid().voxelCount() * first.type().bytes());
    return new StreamVolumeReader(header, files(), data, NonSpatialAxis.NONE, options.progress());
  }

  private Vec3 spacing(TiffPage first, ImagejDescription imagej) {
    double mm = imagej.mmPerUnit();
    if (Double.isNaN(mm) && first.resolutionUnit() == 3) {
      mm = 10;
    }
    double x = mm / first.resolution(282);
    double y = mm / first.resolution(283);
    if (!(x > 0 && y > 0) || Double.isInfinite(x) || Double.isInfinite(y)) {
      notes.add("the pixel size is unknown: 1 mm assumed");
      mm = 1;
      x = 1;
      y = 1;
    }
    double z = imagej.spacing() * mm;
    if (!(z > 0) || Double.isInfinite(z)) {
      notes.add("the slice spacing is unknown: taken to be the pixel spacing");
      z = x;
    }
    return new Vec3(x, y, z);
  }

  private static String compressionName(TiffPage page) {
    return switch (page.compression()) {
      case 1 -> "uncompressed";
      case 5 -> "LZW";
      case 32773 -> "PackBits";
      default -> "deflate";
    };
  }

  @Override
  public VolumeHeader header() {
    return header;
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    VoxelSlice slice = MemoryCheck.slice(header.grid(), header.values().isInteger(), sourceName());
    MemoryCheck.require(4.0 * slice.count() * header.type().bytes(), "one page", sourceName());
    int k = 0;
    try (FileChannel channel = FileChannel.open(tiff.file())) {
      TiffDecoder decoder = new TiffDecoder(channel, tiff.order(), scaling);
      for (; k < slices.size(); k++) {
        decoder.decode(slices.get(k), slice);
        sink.accept(k, slice);
        options.progress().slicesRead(k + 1, slices.size());
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          String.format(Locale.ROOT, "page %d is damaged (%s)", k + 1, e.getMessage()),
          sourceName(),
          "copy or export the file again",
          e);
    }
  }

  @Override
  public String sourceName() {
    return tiff.file().toString();
  }

  @Override
  public List<Path> files() {
    return List.of(tiff.file());
  }
}
