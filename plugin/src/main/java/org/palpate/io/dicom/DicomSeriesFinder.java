package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Finds the DICOM series in a folder, without its sub-folders and in any order of files, and
 * selects one.
 */
final class DicomSeriesFinder {
  private static final int START_BYTES = 132;
  private static final int MAX_LISTED = 6;

  private DicomSeriesFinder() {}

  /**
   * Returns the files of one series, the only one or the one that the options choose.
   *
   * @throws VolumeFormatException if the folder has no series, or several and none is chosen
   */
  static List<DicomFile> find(Path folder, ReadOptions options) throws VolumeFormatException {
    List<List<DicomFile>> series = series(pictures(folder));
    if (series.isEmpty()) {
      throw new VolumeFormatException(
          "the folder has no DICOM image",
          folder,
          "name the folder that directly contains the files, or a single file");
    }
    return chosen(series, folder, options);
  }

  private static List<DicomFile> pictures(Path folder) throws VolumeFormatException {
    List<Path> paths = new ArrayList<>();
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
      for (Path entry : entries) {
        if (Files.isRegularFile(entry)) {
          paths.add(entry);
        }
      }
    } catch (IOException e) {
      throw InputFiles.unreadableFile(folder, e);
    }
    Collections.sort(paths); // the order of the folder differs between systems
    List<DicomFile> pictures = new ArrayList<>();
    for (Path path : paths) {
      if (DicomFile.isDicom(InputFiles.firstBytes(path, START_BYTES))) {
        DicomFile file = DicomFile.read(path);
        if (file.hasPixels()) {
          pictures.add(file);
        }
      }
    }
    return pictures;
  }

  /** Groups files by series, size and orientation, so that a localizer is a series of its own. */
  private static List<List<DicomFile>> series(List<DicomFile> pictures) {
    Map<String, List<DicomFile>> byKey = new LinkedHashMap<>();
    for (DicomFile file : pictures) {
      byKey.computeIfAbsent(key(file), unused -> new ArrayList<>()).add(file);
    }
    List<List<DicomFile>> series = new ArrayList<>(byKey.values());
    series.sort(
        Comparator.comparingInt((List<DicomFile> files) -> number(files.get(0)))
            .thenComparing(files -> key(files.get(0))));
    return series;
  }

  private static String key(DicomFile file) {
    StringBuilder key = new StringBuilder(file.attributes().text(DicomTag.SERIES_UID));
    key.append(' ').append(file.columns()).append('x').append(file.rows());
    double[] axes = file.attributes().decimals(DicomTag.ORIENTATION, 6);
    for (int n = 0; axes != null && n < 6; n++) {
      key.append(' ').append(Math.rint(axes[n] * 100) + 0.0);
    }
    return key.toString();
  }

  private static int number(DicomFile file) {
    return NumberParser.positiveInt(file.attributes().text(DicomTag.SERIES_NUMBER));
  }

  private static List<DicomFile> chosen(
      List<List<DicomFile>> series, Path folder, ReadOptions options) throws VolumeFormatException {
    Optional<String> wanted = options.series();
    if (wanted.isEmpty() && series.size() == 1) {
      return series.get(0);
    }
    int number = wanted.map(NumberParser::positiveInt).orElse(0);
    if (number >= 1 && number <= series.size()) {
      return series.get(number - 1);
    }
    for (List<DicomFile> files : series) {
      String uid = files.get(0).attributes().text(DicomTag.SERIES_UID);
      if (wanted.isPresent() && !uid.isEmpty() && uid.equals(wanted.get())) {
        return files;
      }
    }
    String list = list(series);
    throw new VolumeFormatException(
        wanted.isPresent()
            ? "the folder has no series '" + wanted.get() + "', only " + list
            : "the folder has " + series.size() + " series: " + list,
        folder,
        "choose one with --series 1 to --series " + series.size());
  }

  /** Lists numbers, modalities and sizes, and nothing that identifies a patient or a date. */
  private static String list(List<List<DicomFile>> series) {
    StringBuilder list = new StringBuilder();
    for (int n = 0; n < Math.min(series.size(), MAX_LISTED); n++) {
      DicomFile first = series.get(n).get(0);
      String modality = first.attributes().text(DicomTag.MODALITY);
      list.append(n == 0 ? "" : "; ").append(n + 1).append(" ");
      list.append(modality.matches("[A-Z]{2,4}") ? modality + ", " : "");
      int files = series.get(n).size();
      list.append(files).append(files == 1 ? " file of " : " files of ");
      list.append(first.columns()).append('x').append(first.rows());
    }
    return series.size() > MAX_LISTED ? list + "; and more" : list.toString();
  }
}
