package org.palpate.io.tiff;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.NaturalOrder;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.StreamVolumeReader;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;

/**
 * Reads TIFF stacks, one page a slice, and folders of TIFF slices. Understands the spacing,
 * calibration, times and channels of ImageJ and of OME-XML, and ImageJ's large stacks with a single
 * page.
 *
 * <p>Source: TIFF Revision 6.0; ImageJ's description tag as its TiffEncoder writes it; OME-TIFF
 * specification.
 */
public final class TiffReader implements VolumeReader {
  private static final int MAX_FILES = 100_000;

  private final TiffStack stack;
  private final Path source;
  private final List<Path> files;
  private final ReadOptions options;

  private TiffReader(TiffStack stack, Path source, List<Path> files, ReadOptions options) {
    this.stack = stack;
    this.source = source;
    this.files = files;
    this.options = options;
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
    TiffReader reader =
        new TiffReader(TiffStack.of(TiffFile.read(file), options), file, List.of(file), options);
    return reader.stack.isContiguous() ? reader.contiguousStack() : reader;
  }

  /**
   * Returns the TIFF files of a folder in the natural order of their names, in which 2 comes before
   * 10.
   */
  public static List<Path> filesOf(Path folder) throws VolumeFormatException {
    List<Path> found = new ArrayList<>();
    for (Path entry : InputFiles.entries(folder)) {
      if (isTiffFile(entry)) {
        found.add(entry);
      }
    }
    found.sort(NaturalOrder.OF_FILE_NAMES);
    return found;
  }

  private static boolean isTiffFile(Path file) throws VolumeFormatException {
    return InputFiles.hasEnding(file, ".tif", ".tiff")
        && !file.getFileName().toString().startsWith(".")
        && Files.isRegularFile(file)
        && TiffFile.isTiff(InputFiles.firstBytes(file, 4));
  }

  /**
   * Opens files of one page each as the slices of one stack.
   *
   * @param slices the files in the order of the slices, at least one
   * @throws VolumeFormatException if a file is damaged, or differs from the others
   */
  public static VolumeReader openSlices(Path folder, List<Path> slices, ReadOptions options)
      throws VolumeFormatException {
    if (slices.size() > MAX_FILES) {
      throw new VolumeFormatException(
          "the folder has " + slices.size() + " TIFF files, more than " + MAX_FILES,
          folder,
          "keep the slices of one volume in it");
    }
    List<TiffFile> tiffs = new ArrayList<>();
    for (Path slice : slices) {
      tiffs.add(TiffFile.read(slice));
    }
    return new TiffReader(TiffStack.ofSlices(folder, tiffs, options), folder, slices, options);
  }

  /** Reads the slices that ImageJ stored one after another behind a single page. */
  private VolumeReader contiguousStack() throws VolumeFormatException {
    TiffPage first = stack.slices().get(0);
    PlaneTable planes = stack.planes();
    long sliceBytes = first.pixels().rowBytes(first.width()) * first.height();
    long timeBytes = sliceBytes * planes.slices() * planes.channels();
    int time = stack.chosen() / planes.channels();
    BinaryData data =
        new BinaryData(
            files,
            new BinaryData.Start((long) first.offsets()[0] + time * timeBytes, false, false),
            first.pixels().type(),
            first.tiff().order(),
            stack.scaling(),
            timeBytes);
    NonSpatialAxis channels =
        planes.channels() == 1
            ? NonSpatialAxis.NONE
            : new NonSpatialAxis(2, planes.channels(), stack.chosen() % planes.channels());
    return new StreamVolumeReader(stack.header(), files, data, channels, options.progress());
  }

  @Override
  public VolumeHeader header() {
    return stack.header();
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    VolumeHeader header = header();
    VoxelSlice slice = MemoryCheck.slice(header.grid(), header.values().isInteger(), sourceName());
    List<TiffPage> slices = stack.slices();
    TiffPixels pixels = slices.get(0).pixels();
    double pageBytes = (double) slice.count() * header.type().bytes() * pixels.samples();
    MemoryCheck.require(4.0 * pageBytes, "one page", sourceName());
    int k = 0;
    while (k < slices.size()) {
      k = readFile(k, slice, sink);
    }
  }

  /** Reads slices from k on as long as they stand in one file, and returns the next one. */
  private int readFile(int from, VoxelSlice slice, SliceSink sink) throws VolumeFormatException {
    List<TiffPage> slices = stack.slices();
    TiffFile tiff = slices.get(from).tiff();
    int k = from;
    try (FileChannel channel = FileChannel.open(tiff.file())) {
      TiffDecoder decoder = new TiffDecoder(channel, tiff.order(), stack.scaling());
      for (; k < slices.size() && slices.get(k).tiff() == tiff; k++) {
        decoder.decode(slices.get(k), slice);
        sink.accept(k, slice);
        options.progress().slicesRead(k + 1, slices.size());
      }
      return k;
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          String.format(Locale.ROOT, "slice %d is damaged (%s)", k + 1, e.getMessage()),
          tiff.file(),
          "copy or export the file again",
          e);
    }
  }

  @Override
  public String sourceName() {
    return source.toString();
  }

  @Override
  public List<Path> files() {
    return files;
  }
}
