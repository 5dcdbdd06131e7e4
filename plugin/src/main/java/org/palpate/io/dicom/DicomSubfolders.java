package org.palpate.io.dicom;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.palpate.io.format.InputFiles;

/** Finds the sub-folders of a folder that hold DICOM images. */
final class DicomSubfolders {
  private static final int MAX_DEPTH = 4;

  /** Files that are looked at in a sub-folder, so that a whole disk is not searched. */
  private static final int MAX_FILES = 200;

  private DicomSubfolders() {}

  /** Returns the folders that hold a DICOM file, perhaps deeper inside. */
  static List<Path> withImages(List<Path> folders) {
    return folders.stream().filter(DicomSubfolders::holdsDicom).toList();
  }

  private static boolean holdsDicom(Path folder) {
    try (Stream<Path> files = Files.walk(folder, MAX_DEPTH)) {
      return files.limit(MAX_FILES).filter(Files::isRegularFile).anyMatch(DicomSubfolders::isDicom);
    } catch (IOException | UncheckedIOException e) {
      return false; // a folder that cannot be read has no image for us
    }
  }

  private static boolean isDicom(Path file) {
    try {
      return DicomRecognizer.isDicom(InputFiles.firstBytes(file, DicomRecognizer.START_BYTES));
    } catch (IOException e) {
      return false;
    }
  }
}
