package org.palpate.io;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.GZIPOutputStream;
import org.palpate.io.dicom.DicomSegmentationWriter;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.SliceWriter;
import org.palpate.io.nifti.NiftiHeaderWriter;
import org.palpate.io.nrrd.NrrdHeaderWriter;
import org.palpate.io.tiff.ImagejTiffWriter;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelType;

/**
 * Writes a volume slice by slice as NRRD, NIfTI or ImageJ's TIFF, or its labels as DICOM. The
 * ending of the target's name chooses the format. The target is replaced only when the file is
 * complete, and an input is never overwritten.
 */
public final class VolumeWriter {
  private static final String DICOM_ENDING = ".dcm";

  private VolumeWriter() {}

  /**
   * Writes all values of a volume and returns the format in words. NRRD and NIfTI keep the type of
   * the volume. If its rescaling leads beyond that type, they get a wider one: 16 or 32 bits for
   * integers, else doubles. A TIFF gets the narrowest type of ImageJ that holds the values.
   *
   * @param target ends in {@code .nrrd}, {@code .nii}, {@code .nii.gz}, {@code .tif}, {@code .tiff}
   *     or {@code .dcm}
   * @throws VolumeFormatException if the volume cannot be read or the target cannot be written
   */
  public static String write(VolumeReader volume, Path target) throws VolumeFormatException {
    checkName(target);
    refuseInputs(volume, target);
    try (AtomicFile file = new AtomicFile(target)) {
      String words = write(volume, lowerCaseName(target), file.stream());
      file.stream().flush();
      file.commit();
      return words;
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the file cannot be written (" + e.getMessage() + ")",
          target,
          "choose a folder that exists, may be written to and has room",
          e);
    }
  }

  private static String write(VolumeReader volume, String name, OutputStream out)
      throws IOException {
    if (name.endsWith(DICOM_ENDING)) {
      return DicomSegmentationWriter.write(volume, out);
    }
    if (isTiff(name)) {
      return ImagejTiffWriter.write(volume, out);
    }
    VoxelType type = type(volume.header());
    if (!isNifti(name)) {
      out.write(NrrdHeaderWriter.of(volume.header(), type));
      writeGzip(volume, type, out, new byte[0]);
      return "NRRD, gzip";
    }
    byte[] header = NiftiHeaderWriter.of(volume.header(), type);
    if (name.endsWith(".gz")) {
      writeGzip(volume, type, out, header);
    } else {
      out.write(header);
      writeSamples(volume, type, out);
    }
    return NiftiHeaderWriter.formatName(volume.header())
        + (name.endsWith(".gz") ? ", gzip" : "")
        + volume.header().axesTakenAs(CoordinateSystem.RAS);
  }

  private static void writeGzip(
      VolumeReader volume, VoxelType type, OutputStream out, byte[] header) throws IOException {
    GZIPOutputStream gzip = new GZIPOutputStream(out, InputFiles.BUFFER_BYTES);
    gzip.write(header);
    writeSamples(volume, type, gzip);
    gzip.finish();
  }

  /**
   * Checks the ending of a target's name before any work is done.
   *
   * @throws VolumeFormatException if {@link #write} knows no format for it
   */
  public static void checkName(Path target) throws VolumeFormatException {
    String name = lowerCaseName(target);
    if (!isNifti(name) && !isTiff(name) && !isDicom(target) && !name.endsWith(".nrrd")) {
      throw new VolumeFormatException(
          "volumes cannot be written in this format",
          target,
          "name it .nrrd, .nii, .nii.gz or .tif, or .dcm for segments");
    }
  }

  private static String lowerCaseName(Path target) {
    return target.getFileName().toString().toLowerCase(Locale.ROOT);
  }

  private static boolean isNifti(String name) {
    return name.endsWith(".nii") || name.endsWith(".nii.gz");
  }

  /** Whether a target is written as a DICOM segmentation, which holds segments only. */
  public static boolean isDicom(Path target) {
    return lowerCaseName(target).endsWith(DICOM_ENDING);
  }

  private static boolean isTiff(String name) {
    return name.endsWith(".tif") || name.endsWith(".tiff");
  }

  private static void refuseInputs(VolumeReader volume, Path target) throws VolumeFormatException {
    for (Path input : volume.files()) {
      try {
        if (Files.exists(target) && Files.isSameFile(input, target)) {
          throw new VolumeFormatException(
              "the target is the volume that is read", target, "write to another file");
        }
      } catch (VolumeFormatException e) {
        throw e;
      } catch (IOException e) {
        throw InputFiles.unreadableFile(target, e);
      }
    }
  }

  /** Returns the stored type if it holds every value after scaling, else a type that does. */
  private static VoxelType type(VolumeHeader header) {
    VolumeHeader.ValueRange values = header.values();
    boolean asStored = values.low() >= header.type().low() && values.high() <= header.type().high();
    if (values.isInteger()) {
      return asStored
          ? header.type()
          : values.low() >= VoxelType.INT16.low() && values.high() <= VoxelType.INT16.high()
              ? VoxelType.INT16
              : VoxelType.INT32;
    }
    return header.type() == VoxelType.FLOAT32
            && values.equals(VolumeHeader.ValueRange.of(header.type()))
        ? VoxelType.FLOAT32
        : VoxelType.FLOAT64;
  }

  private static void writeSamples(VolumeReader volume, VoxelType type, OutputStream out)
      throws IOException {
    int count = volume.header().grid().sizeX() * volume.header().grid().sizeY();
    MemoryCheck.require((double) count * type.bytes(), "one slice", volume.sourceName());
    ByteBuffer bytes =
        ByteBuffer.allocate(Math.multiplyExact(count, type.bytes())).order(ByteOrder.LITTLE_ENDIAN);
    SliceWriter.writeAll(
        volume::read,
        (k, slice) -> {
          bytes.clear();
          for (int n = 0; n < count; n++) {
            put(slice.value(n), type, bytes);
          }
          out.write(bytes.array(), 0, bytes.position());
        });
  }

  private static void put(double value, VoxelType type, ByteBuffer bytes) {
    switch (type) {
      case INT8, UINT8 -> bytes.put((byte) (int) value);
      case INT16, UINT16 -> bytes.putShort((short) (int) value);
      case INT32 -> bytes.putInt((int) value);
      case FLOAT32 -> bytes.putFloat((float) value);
      default -> bytes.putDouble(value);
    }
  }
}
