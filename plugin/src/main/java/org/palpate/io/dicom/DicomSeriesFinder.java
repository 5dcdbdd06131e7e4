package org.palpate.io.dicom;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Finds the DICOM series in a folder, without its sub-folders and in any order of files, and
 * selects one.
 */
final class DicomSeriesFinder {
  private static final int MAX_LISTED = 6;

  private DicomSeriesFinder() {}

  /**
   * The files of a series.
   *
   * @param files at least one
   * @param notes what was left out of the folder
   */
  record Found(List<DicomFile> files, List<String> notes) {}

  /**
   * Returns the files of one series, the only one or the one that the options choose.
   *
   * @throws VolumeFormatException if the folder has no series, or several and none is chosen
   */
  static Found find(Path folder, ReadOptions options) throws VolumeFormatException {
    List<Path> entries = InputFiles.entries(folder);
    List<Path> paths = entries.stream().filter(Files::isRegularFile).toList();
    List<Path> subfolders = entries.stream().filter(Files::isDirectory).toList();
    List<Path> strangers = new ArrayList<>();
    List<List<DicomFile>> series = series(pictures(paths, strangers));
    if (series.isEmpty()) {
      throw withoutImage(folder, subfolders);
    }
    List<String> notes = new ArrayList<>();
    if (!strangers.isEmpty()) {
      notes.add("left out, because no DICOM image: " + fileList(strangers));
    }
    List<Path> others = DicomSubfolders.withImages(subfolders);
    if (!others.isEmpty()) {
      notes.add("the images of sub-folders are not read: " + fileList(others));
    }
    return new Found(chosen(series, folder, options), notes);
  }

  private static VolumeFormatException withoutImage(Path folder, List<Path> subfolders) {
    List<Path> others = DicomSubfolders.withImages(subfolders);
    if (others.isEmpty()) {
      return new VolumeFormatException(
          "the folder has no DICOM image",
          folder,
          "name the folder that directly contains the files, or a single file");
    }
    return new VolumeFormatException(
        "the folder has no DICOM image of its own, but its sub-folders have: " + fileList(others),
        folder,
        "name one of them, or put the files of one series into one folder");
  }

  /** Returns the images among some files; the rest is added to the strangers. */
  private static List<DicomFile> pictures(List<Path> paths, List<Path> strangers)
      throws VolumeFormatException {
    List<DicomFile> pictures = new ArrayList<>();
    for (Path path : paths) {
      byte[] start = InputFiles.firstBytes(path, DicomRecognizer.START_BYTES);
      boolean listOfFiles = path.getFileName().toString().equalsIgnoreCase("DICOMDIR");
      Optional<DicomFile> file =
          listOfFiles || !DicomRecognizer.isDicom(start)
              ? Optional.empty()
              : Optional.of(DicomFile.read(path)).filter(DicomFile::hasPixels);
      file.ifPresentOrElse(pictures::add, () -> strangers.add(path));
    }
    return pictures;
  }

  /** Lists the names of some files. */
  static String fileList(Collection<Path> files) {
    String names =
        files.stream()
            .limit(MAX_LISTED)
            .map(file -> file.getFileName().toString())
            .collect(Collectors.joining(", "));
    return files.size() > MAX_LISTED
        ? names + " and " + (files.size() - MAX_LISTED) + " more"
        : names;
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
