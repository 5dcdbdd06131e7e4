package org.palpate.io;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.dicom.DicomReader;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.label.LabelledReader;
import org.palpate.io.metaimage.MetaImageReader;
import org.palpate.io.nifti.NiftiReader;
import org.palpate.io.nrrd.NrrdReader;
import org.palpate.io.raw.RawReader;
import org.palpate.io.tiff.TiffReader;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Recognizes the format of a file and opens it. */
public final class VolumeFiles {
  private static final int START_BYTES = 1024;

  /** The formats in the order in which they are asked; a DICOM file may begin as a TIFF does. */
  private static final List<Format> FORMATS =
      List.of(
          new Format(NrrdReader::accepts, NrrdReader::open),
          new Format(DicomReader::accepts, DicomReader::open),
          new Format(TiffReader::accepts, TiffReader::open),
          new Format(NiftiReader::accepts, NiftiReader::open),
          new Format(MetaImageReader::accepts, MetaImageReader::open));

  private VolumeFiles() {}

  private record Format(Recognizer recognizer, Opener opener) {}

  private interface Recognizer {
    /** Returns whether the format reads a file with these first bytes and this name. */
    boolean accepts(byte[] start, Path file) throws VolumeFormatException;
  }

  private interface Opener {
    VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException;
  }

  /**
   * Opens a volume: reads its header and checks its sizes against the length of its files. Reads no
   * voxel, and costs little memory whatever the header claims.
   *
   * @param file a file, or a folder of DICOM files, TIFF slices or raw slices
   * @throws VolumeFormatException if it is no volume, is damaged, or needs another option
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    if (Files.isDirectory(file) && options.raw().isEmpty()) {
      return openFolder(file, options);
    }
    ReadOptionChecks.refuseSeriesOption(options, file);
    if (options.raw().isPresent()) {
      return RawReader.open(file, options.raw().get(), options);
    }
    return LabelledReader.of(openFile(file, options), file);
  }

  /** Opens a folder of TIFF slices, or else one of DICOM files. */
  private static VolumeReader openFolder(Path folder, ReadOptions options)
      throws VolumeFormatException {
    List<Path> slices = TiffReader.filesOf(folder);
    if (slices.isEmpty() || hasDicomFile(folder)) {
      return DicomReader.openFolder(folder, options);
    }
    ReadOptionChecks.refuseSeriesOption(options, folder);
    return TiffReader.openSlices(folder, slices, options);
  }

  private static boolean hasDicomFile(Path folder) throws VolumeFormatException {
    for (Path entry : InputFiles.entries(folder)) {
      if (Files.isRegularFile(entry)
          && DicomReader.accepts(InputFiles.firstBytes(entry, START_BYTES), entry)) {
        return true;
      }
    }
    return false;
  }

  private static VolumeReader openFile(Path file, ReadOptions options)
      throws VolumeFormatException {
    if (InputFiles.length(file) == 0) {
      throw new VolumeFormatException("the file is empty", file, "copy or export it again");
    }
    byte[] start = InputFiles.firstBytes(file, START_BYTES);
    for (Format format : FORMATS) {
      if (format.recognizer().accepts(start, file)) {
        return format.opener().open(file, options);
      }
    }
    throw unknownFormat(file);
  }

  private static VolumeFormatException unknownFormat(Path file) {
    if (InputFiles.hasEnding(file, ".dcm", ".ima")) {
      return new VolumeFormatException(
          "the file is named like DICOM but has neither the letters DICM after its first 128 bytes"
              + " nor attributes at its start",
          file,
          "export it again, or convert it with gdcmconv --raw IN OUT (free, from GDCM)");
    }
    return new VolumeFormatException(
        "the format of the file is unknown",
        file,
        "give NRRD, NIfTI, MetaImage, TIFF or DICOM, or describe a raw file with --raw");
  }
}
