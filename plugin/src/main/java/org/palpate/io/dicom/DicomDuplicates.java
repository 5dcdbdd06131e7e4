package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.VolumeFormatException;

/** Drops copies of slices: files with the same bytes, or with the same instance and pixels. */
final class DicomDuplicates {
  private DicomDuplicates() {}

  /**
   * Returns the frames without copies. A note names the files that were dropped.
   *
   * @throws VolumeFormatException if two files that may be copies cannot be compared
   */
  static List<DicomFrame> drop(List<DicomFrame> frames, List<String> notes)
      throws VolumeFormatException {
    if (frames.stream().anyMatch(frame -> frame.plane().isEmpty())) {
      return frames;
    }
    List<DicomFrame> kept = new ArrayList<>(frames);
    Set<Path> dropped = new TreeSet<>();
    for (List<DicomFrame> group : PositionGroups.of(frames).groups()) {
      List<DicomFrame> originals = new ArrayList<>();
      for (DicomFrame frame : byName(group)) {
        if (isCopyOfOne(frame, originals)) {
          kept.remove(frame);
          dropped.add(frame.dicom().file());
        } else {
          originals.add(frame);
        }
      }
    }
    if (!dropped.isEmpty()) {
      notes.add("copies of other slices are left out: " + DicomSeriesFinder.fileList(dropped));
    }
    return kept;
  }

  /** Sorts frames so that "im1" stands before "copy of im1". */
  private static List<DicomFrame> byName(List<DicomFrame> group) {
    List<DicomFrame> sorted = new ArrayList<>(group);
    if (group.size() > 1) {
      sorted.sort(
          Comparator.comparingInt((DicomFrame frame) -> frame.dicom().file().toString().length())
              .thenComparing(frame -> frame.dicom().file()));
    }
    return sorted;
  }

  private static boolean isCopyOfOne(DicomFrame frame, List<DicomFrame> originals)
      throws VolumeFormatException {
    for (DicomFrame original : originals) {
      if (isCopy(frame, original)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isCopy(DicomFrame a, DicomFrame b) throws VolumeFormatException {
    Path first = a.dicom().file();
    Path second = b.dicom().file();
    if (first.equals(second)) {
      return false; // two frames of one file
    }
    try {
      if (a.index() == b.index() && Files.mismatch(first, second) < 0) {
        return true;
      }
      String instance = a.dicom().attributes().text(DicomTag.SOP_INSTANCE);
      return !instance.isEmpty()
          && instance.equals(b.dicom().attributes().text(DicomTag.SOP_INSTANCE))
          && hasSamePixels(a, b);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw InputFiles.unreadableFile(first, e);
    }
  }

  private static boolean hasSamePixels(DicomFrame a, DicomFrame b) throws VolumeFormatException {
    double pixels = (double) a.dicom().rows() * a.dicom().columns();
    MemoryCheck.require(16 * pixels, "comparing two frames", a.dicom().file().toString());
    try (DicomPixelDecoder one = new DicomPixelDecoder();
        DicomPixelDecoder other = new DicomPixelDecoder()) {
      int count = Math.toIntExact((long) pixels);
      int[] first = one.storedValues(a.dicom(), a.index(), count);
      int[] second = other.storedValues(b.dicom(), b.index(), count);
      return a.scaling().equals(b.scaling()) && Arrays.equals(first, 0, count, second, 0, count);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException | ArithmeticException e) {
      throw a.dicom().damagedPixels(e);
    }
  }
}
