package org.palpate.io.tiff;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.Grids;
import org.palpate.io.format.Luminance;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.volume.VoxelGrid;

/**
 * The pages of a stack in the order of its slices, and what its descriptions state.
 *
 * @param slices a page for each slice; a single page if ImageJ stored all slices after it
 * @param chosen the number of the stack that is read, from 0, if there are several channels or
 *     times
 * @param planes the arrangement of channels, slices and times
 * @param scaling maps stored numbers to values
 * @param header the header of the volume
 */
record TiffStack(
    List<TiffPage> slices, int chosen, PlaneTable planes, Scaling scaling, VolumeHeader header) {

  /** Arranges the pages of one file. */
  static TiffStack of(TiffFile tiff, ReadOptions options) throws VolumeFormatException {
    return new Reading(tiff.file(), options).ofFile(pages(tiff));
  }

  /** Arranges files of one page each as the slices of a stack. */
  static TiffStack ofSlices(Path folder, List<TiffFile> files, ReadOptions options)
      throws VolumeFormatException {
    return new Reading(folder, options).ofSlices(files);
  }

  /** Returns the pages of a file that are no reduced copies of others. */
  private static List<TiffPage> pages(TiffFile tiff) throws VolumeFormatException {
    List<TiffPage> pages =
        tiff.pages().stream()
            .map(tags -> new TiffPage(tiff, tags))
            .filter(page -> !page.isReduced())
            .toList();
    if (pages.isEmpty()) {
      throw new VolumeFormatException("the file has no page", tiff.file(), "save the stack again");
    }
    return pages;
  }

  /** Whether ImageJ stored all slices after the only page. */
  boolean isContiguous() {
    return header.grid().sizeZ() > slices.size();
  }

  /** Holds the state while one stack is arranged. */
  private static final class Reading {
    private final Path source;
    private final ReadOptions options;
    private final List<String> notes = new ArrayList<>();

    Reading(Path source, ReadOptions options) {
      this.source = source;
      this.options = options;
    }

    TiffStack ofFile(List<TiffPage> pages) throws VolumeFormatException {
      TiffPage first = pages.get(0);
      first.check();
      Optional<OmeXml> ome = OmeXml.of(first.description());
      ImagejDescription imagej = ImagejDescription.of(first.description());
      boolean contiguous = ome.isEmpty() && isContiguous(pages, imagej);
      if (contiguous) {
        requireRoom(first, imagej.images());
      }
      PlaneTable planes =
          ome.isPresent()
              ? omePlanes(ome.get(), pages.size())
              : imagejPlanes(first, imagej, contiguous ? imagej.images() : pages.size());
      int stack =
          ReadOptionChecks.chosenStep(
              planes.stacks(), planes.description(), options, source, notes);
      noteChannelAndTime(planes, stack);
      List<TiffPage> slices = new ArrayList<>();
      if (contiguous) {
        slices.add(first);
      } else {
        for (int z = 0; z < planes.slices(); z++) {
          slices.add(pages.get(planes.page(stack, z)));
        }
        requireEqualPages(first, pages, slices);
      }
      return stack(slices, stack, planes, imagej, ome);
    }

    TiffStack ofSlices(List<TiffFile> files) throws VolumeFormatException {
      List<TiffPage> slices = new ArrayList<>();
      for (TiffFile tiff : files) {
        List<TiffPage> pages = pages(tiff);
        if (pages.size() > 1) {
          throw new VolumeFormatException(
              "a file of the folder has " + pages.size() + " pages, not one",
              tiff.file(),
              "name this file alone, or leave one slice in each file");
        }
        slices.add(pages.get(0));
      }
      TiffPage first = slices.get(0);
      requireEqualPages(first, slices, slices);
      ReadOptionChecks.chosenStep(1, options, source, notes);
      notes.add(
          slices.size()
              + " files in the order of the numbers in their names, from "
              + first.tiff().file().getFileName()
              + " to "
              + slices.get(slices.size() - 1).tiff().file().getFileName());
      PlaneTable planes = PlaneTable.channelsFirst(slices.size(), 1, 1);
      ImagejDescription imagej = ImagejDescription.of(first.description());
      return stack(slices, 0, planes, imagej, OmeXml.of(first.description()));
    }

    private static boolean isContiguous(List<TiffPage> pages, ImagejDescription imagej) {
      return pages.size() == 1
          && imagej.images() > 1
          && pages.get(0).compression() == 1
          && !pages.get(0).isTiled();
    }

    private PlaneTable omePlanes(OmeXml ome, int pageCount) throws VolumeFormatException {
      PlaneTable planes = ome.planes(pageCount);
      if (planes.missing(pageCount) > 0) {
        boolean others = ome.fileNames().size() > 1;
        throw new VolumeFormatException(
            "the OME-XML promises "
                + planes.planes()
                + " planes but the file has "
                + pageCount
                + " pages"
                + (others ? ", and names " + ome.fileNames().size() + " files" : ""),
            source,
            others
                ? "join the files with: bfconvert IN OUT.ome.tif (free, from Bio-Formats)"
                : "copy the file again; if that does not help, export it again");
      }
      if (ome.images() > 1) {
        notes.add("the file has " + ome.images() + " images: the first one is read");
      }
      return planes;
    }

    private PlaneTable imagejPlanes(TiffPage first, ImagejDescription imagej, int pageCount)
        throws VolumeFormatException {
      if (imagej.images() > pageCount) {
        throw new VolumeFormatException(
            "the description promises "
                + imagej.images()
                + " images but the file has "
                + pageCount
                + " pages",
            source,
            "copy the file again; if that does not help, save it again in ImageJ");
      }
      int stacks = imagej.channels() * imagej.frames();
      int slices = imagej.slices() > 0 && stacks > 1 ? imagej.slices() : pageCount / stacks;
      if ((long) slices * stacks != pageCount) {
        throw first.refusal(
            "the description states "
                + imagej.channels()
                + " channels and "
                + imagej.frames()
                + " times, which do not divide "
                + pageCount
                + " pages");
      }
      return PlaneTable.channelsFirst(slices, imagej.channels(), imagej.frames());
    }

    private void noteChannelAndTime(PlaneTable planes, int stack) {
      if (planes.channels() > 1 && planes.times() > 1) {
        notes.add(
            "channel "
                + stack % planes.channels()
                + " of "
                + planes.channels()
                + " at time "
                + stack / planes.channels()
                + " of "
                + planes.times()
                + ", counted from 0");
      }
    }

    /** Refuses pages that differ from the first one, even those that are not read. */
    private void requireEqualPages(TiffPage first, List<TiffPage> all, List<TiffPage> read)
        throws VolumeFormatException {
      for (TiffPage slice : read) {
        slice.check();
      }
      for (int n = 1; n < all.size(); n++) {
        TiffPage page = all.get(n);
        boolean same = page.width() == first.width() && page.height() == first.height();
        if (!same || !page.pixels().equals(first.pixels())) {
          throw different(first, page, page.tiff() == first.tiff() ? "page " + (n + 1) : "it");
        }
      }
    }

    private static VolumeFormatException different(TiffPage first, TiffPage page, String name)
        throws VolumeFormatException {
      boolean sameFile = page.tiff() == first.tiff();
      return new VolumeFormatException(
          name
              + " has "
              + words(page)
              + " but "
              + (sameFile ? "page 1" : first.tiff().file().getFileName().toString())
              + " has "
              + words(first),
          page.tiff().file(),
          sameFile
              ? "save the pages of one size and type as a stack of their own"
              : "leave slices of one size and type in the folder");
    }

    private static String words(TiffPage page) throws VolumeFormatException {
      return page.width()
          + "x"
          + page.height()
          + " pixels of "
          + (page.pixels().samples() > 1 ? page.pixels().samples() + " x " : "")
          + page.pixels().bits()
          + " bits";
    }

    private void requireRoom(TiffPage first, int images) throws VolumeFormatException {
      double sliceBytes = (double) first.pixels().rowBytes(first.width()) * first.height();
      double found = Math.floor((first.tiff().length() - first.offsets()[0]) / sliceBytes);
      if (images > found) {
        throw new VolumeFormatException(
            "the description promises "
                + images
                + " slices but the file has room for at most "
                + NumberText.display(found),
            source,
            "copy the file again; if that does not help, export it again");
      }
      if (first.pixels().samples() > 1 || !first.pixels().isPlain()) {
        throw first.refusal("the slices after the only page are no plain grey values");
      }
    }

    private TiffStack stack(
        List<TiffPage> slices,
        int chosen,
        PlaneTable planes,
        ImagejDescription imagej,
        Optional<OmeXml> ome)
        throws VolumeFormatException {
      TiffPage first = slices.get(0);
      Vec3 spacing = TiffSpacing.of(first, imagej, ome, notes);
      int[] sizes = {first.width(), first.height(), planes.slices()};
      VoxelGrid grid = Grids.of(sizes, Grids.steps(spacing), firstCentre(imagej, spacing), source);
      boolean palette = first.pixels().photometric() == TiffPixels.PALETTE;
      Scaling scaling = first.pixels().scaling(palette ? Scaling.NONE : imagej.scaling());
      notePixels(first);
      String by = ome.isPresent() ? " with OME-XML" : imagej.isImagej() ? " of ImageJ" : "";
      VolumeHeader header =
          new VolumeHeader(
              "TIFF" + by + ", " + TiffPage.compressionName(first.compression()),
              grid,
              first.pixels().type(),
              first.greyPalette().isPresent()
                  ? new ValueRange(0, 255, true)
                  : first.pixels().range(scaling),
              CoordinateSystem.UNKNOWN,
              Optional.empty(),
              notes);
      return new TiffStack(slices, chosen, planes, scaling, header);
    }

    /**
     * Returns the centre of the first voxel: ImageJ counts from the corner of a pixel and from its
     * origin, if it states one.
     */
    private static Vec3 firstCentre(ImagejDescription imagej, Vec3 spacing) {
      Vec3 centre = new Vec3();
      if (imagej.origin(0) != 0 || imagej.origin(1) != 0 || imagej.origin(2) != 0) {
        for (int axis = 0; axis < 3; axis++) {
          centre.set(axis, (0.5 - imagej.origin(axis)) * spacing.get(axis));
        }
      }
      return centre;
    }

    private void notePixels(TiffPage first) {
      TiffPixels pixels = first.pixels();
      if (pixels.isColour()) {
        notes.add(Luminance.NOTE);
      } else if (pixels.samples() > 1) {
        notes.add("the second sample of each pixel, its opacity, is left out");
      }
      if (pixels.isInverted()) {
        notes.add("0 is white in the file: the values are inverted, so that white is the highest");
      } else if (pixels.photometric() == TiffPixels.WHITE_IS_ZERO) {
        notes.add("0 is white in the file, but the values are read as they are stored");
      }
      if (first.orientation() != 1) {
        notes.add(
            "the pixels are read as they are stored, as in ImageJ: Orientation "
                + first.orientation()
                + ", by which the picture is mirrored or turned, is not applied");
      }
      if (pixels.photometric() == TiffPixels.PALETTE) {
        notes.add(
            first.greyPalette().isPresent()
                ? "the values are the grey values of the file's palette"
                : "the values are indices of the file's palette of colours");
      }
    }
  }
}
