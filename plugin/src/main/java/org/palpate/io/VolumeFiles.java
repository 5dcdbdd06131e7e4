package org.palpate.io;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.palpate.io.dicom.DicomFile;
import org.palpate.io.dicom.DicomReader;
import org.palpate.io.dicom.DicomSeriesFinder;
import org.palpate.io.format.BinaryData;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.ReadOptionChecks;
import org.palpate.io.label.LabelledReader;
import org.palpate.io.metaimage.MetaImageHeader;
import org.palpate.io.metaimage.MetaImageReader;
import org.palpate.io.nifti.NiftiHeader;
import org.palpate.io.nifti.NiftiReader;
import org.palpate.io.nrrd.NrrdHeader;
import org.palpate.io.nrrd.NrrdReader;
import org.palpate.io.raw.RawReader;
import org.palpate.io.tiff.TiffFile;
import org.palpate.io.tiff.TiffReader;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Finds out what format a file has, and opens it. */
public final class VolumeFiles {
  private static final int START_BYTES = 1024;

  private VolumeFiles() {}

  /**
   * Opens a volume: understands its header and checks its sizes against what is there. Costs next
   * to nothing, whatever the header claims.
   *
   * @throws VolumeFormatException where it is no volume, is damaged, or needs to be told more
   */
  public static VolumeReader open(Path file, ReadOptions options) throws VolumeFormatException {
    if (Files.isDirectory(file) && options.raw().isEmpty()) {
      return DicomSeriesFinder.open(file, options);
    }
    ReadOptionChecks.refuseSeriesOption(options, file);
    if (options.raw().isPresent()) {
      return RawReader.open(file, options.raw().get(), options);
    }
    return LabelledReader.of(openFile(file, options), file);
  }

  private static VolumeReader openFile(Path file, ReadOptions options)
      throws VolumeFormatException {
    if (InputFiles.length(file) == 0) {
      throw new VolumeFormatException("it is empty", file, "copy or export it again");
    }
    byte[] start = InputFiles.firstBytes(file, START_BYTES);
    if (startsWith(start, NrrdHeader.MAGIC)) {
      return NrrdReader.open(file, options);
    }
    if (DicomFile.isDicom(start)) {
      return DicomReader.open(file, options);
    }
    if (TiffFile.isTiff(start)) {
      return TiffReader.open(file, options);
    }
    if (hasEnding(file, ".nii", ".nii.gz", ".hdr", ".hdr.gz", ".img", ".img.gz")
        || NiftiHeader.isNifti(BinaryData.isGzip(start) ? NiftiHeader.start(file) : start)) {
      return NiftiReader.open(file, options);
    }
    if (hasEnding(file, ".mha", ".mhd") || MetaImageHeader.isMeta(start)) {
      return MetaImageReader.open(file, options);
    }
    if (hasEnding(file, ".dcm", ".ima")) {
      throw new VolumeFormatException(
          "it has not the beginning of a DICOM file (128 bytes, then DICM)",
          file,
          "export it again, or convert it with gdcmconv --raw IN OUT (free, from GDCM)");
    }
    throw new VolumeFormatException(
        "it is in no format that is known",
        file,
        "give NRRD, NIfTI, MetaImage, TIFF or DICOM, or say with --raw what a raw file holds");
  }

  private static boolean hasEnding(Path file, String... endings) {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    return Arrays.stream(endings).anyMatch(name::endsWith);
  }

  private static boolean startsWith(byte[] start, String text) {
    return new String(start, StandardCharsets.ISO_8859_1).startsWith(text);
  }
}
