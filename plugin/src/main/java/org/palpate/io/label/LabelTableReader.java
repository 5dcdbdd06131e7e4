package org.palpate.io.label;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.io.format.HeaderLineReader;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Finds and reads the label table of a volume. The table has the same name as the volume, or is the
 * only one in the folder with the same first word. Reads the tables of 3D Slicer ({@code .ctbl})
 * and FreeSurfer, which have one form, and of ITK-SNAP, which quotes its names.
 */
final class LabelTableReader {
  private static final List<String> ENDINGS = List.of(".ctbl", ".label", ".lut", ".txt");
  private static final int MAX_LABELS = 1 << 16;

  // value name red green blue, optionally alpha
  private static final Pattern SLICER =
      Pattern.compile("(\\d{1,9})\\s+(\\S+)\\s+(\\d{1,3})\\s+(\\d{1,3})\\s+(\\d{1,3})(\\s+\\d+)?");

  // value red green blue alpha visible mesh "name"
  private static final Pattern SNAP =
      Pattern.compile(
          "(\\d{1,9})\\s+(\\d{1,3})\\s+(\\d{1,3})\\s+(\\d{1,3})\\s+\\S+\\s+\\d+\\s+\\d+\\s+\"([^\"]*)\"");

  private LabelTableReader() {}

  /** Returns the table beside a volume, if there is one that is understood. */
  static Optional<LabelTable> beside(Path volume) throws VolumeFormatException {
    Path folder = volume.toAbsolutePath().getParent();
    String stem = stem(volume);
    Path found = null;
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
      for (Path entry : entries) {
        if (!isTable(entry)) {
          continue;
        }
        if (stem(entry).equals(stem)) {
          return read(entry);
        }
        if (firstWord(stem(entry)).equals(firstWord(stem))) {
          if (found != null) {
            return Optional.empty(); // ambiguous
          }
          found = entry;
        }
      }
    } catch (IOException e) {
      throw InputFiles.unreadableFile(folder, e);
    }
    return found == null ? Optional.empty() : read(found);
  }

  private static boolean isTable(Path entry) {
    String name = entry.getFileName().toString().toLowerCase(Locale.ROOT);
    return ENDINGS.stream().anyMatch(name::endsWith) && Files.isRegularFile(entry);
  }

  private static String stem(Path file) {
    return file.getFileName().toString().replaceFirst("\\.gz$", "").replaceFirst("\\.[^.]*$", "");
  }

  private static String firstWord(String stem) {
    return stem.split("[-_. ]", 2)[0];
  }

  private static Optional<LabelTable> read(Path file) throws VolumeFormatException {
    Map<Long, Label> labels = new TreeMap<>();
    try (InputStream in = InputFiles.open(file, 0)) {
      HeaderLineReader lines = new HeaderLineReader(in, file);
      for (String line = lines.next();
          line != null && labels.size() < MAX_LABELS;
          line = lines.next()) {
        parseLine(line.strip(), labels);
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw InputFiles.unreadableFile(file, e);
    }
    return labels.isEmpty() ? Optional.empty() : Optional.of(new LabelTable(labels));
  }

  /** Parses a line; one that is no label is a comment or another kind of text. */
  private static void parseLine(String line, Map<Long, Label> labels) {
    Matcher slicer = SLICER.matcher(line);
    Matcher snap = SNAP.matcher(line);
    if (slicer.matches()) {
      String name = slicer.group(2).replace('_', ' ');
      labels.put(Long.parseLong(slicer.group(1)), new Label(name, rgb(slicer, 3)));
    } else if (snap.matches()) {
      labels.put(Long.parseLong(snap.group(1)), new Label(snap.group(5), rgb(snap, 2)));
    }
  }

  private static int rgb(Matcher matcher, int firstGroup) {
    int rgb = 0;
    for (int n = 0; n < 3; n++) {
      rgb = rgb << 8 | Math.min(255, Integer.parseInt(matcher.group(firstGroup + n)));
    }
    return rgb;
  }
}
