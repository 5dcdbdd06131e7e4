package org.palpate.scene.gl;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/**
 * Lines of text in columns that fit into a picture.
 *
 * @param rows number of lines in a column
 * @param widths width of each column, pixels
 * @param fits whether the columns fit
 */
record TextColumns(int rows, List<Integer> widths, boolean fits) {
  private static final int MAX_COLUMNS = 4;

  /**
   * Returns the fewest columns that fit; if none fit, as many as the width permits.
   *
   * @param width measures a line, pixels
   * @param lineHeight height of a line, pixels
   * @param gap space between columns, pixels
   * @param maxWidth width of the picture that may be used, pixels
   * @param maxHeight its height
   */
  static TextColumns of(
      List<String> lines,
      ToIntFunction<String> width,
      double lineHeight,
      double gap,
      double maxWidth,
      double maxHeight) {
    TextColumns best = columns(lines, width, 1, false);
    for (int count = 1; count <= MAX_COLUMNS; count++) {
      TextColumns tried = columns(lines, width, count, true);
      if (tried.totalWidth(gap) > maxWidth) {
        return best;
      }
      best = new TextColumns(tried.rows, tried.widths, tried.rows * lineHeight <= maxHeight);
      if (best.fits) {
        return best;
      }
    }
    return best;
  }

  private static TextColumns columns(
      List<String> lines, ToIntFunction<String> width, int count, boolean fits) {
    int rows = (lines.size() + count - 1) / count;
    List<Integer> widths = new ArrayList<>();
    for (int from = 0; from < lines.size(); from += rows) {
      List<String> column = lines.subList(from, Math.min(lines.size(), from + rows));
      widths.add(column.stream().mapToInt(width).max().orElse(0));
    }
    return new TextColumns(rows, widths, fits);
  }

  /** Returns the width of all columns and the gaps between them. */
  double totalWidth(double gap) {
    return widths.stream().mapToInt(w -> w).sum() + gap * Math.max(0, widths.size() - 1);
  }

  /** Returns lines that are no wider than {@code maxWidth}, broken between words. */
  static List<String> wrap(List<String> lines, ToIntFunction<String> width, double maxWidth) {
    List<String> wrapped = new ArrayList<>();
    for (String line : lines) {
      String rest = line;
      while (width.applyAsInt(rest) > maxWidth && breakAt(rest, width, maxWidth) > 0) {
        int at = breakAt(rest, width, maxWidth);
        wrapped.add(rest.substring(0, at).stripTrailing());
        rest = rest.substring(at).strip();
      }
      wrapped.add(rest);
    }
    return wrapped;
  }

  /** Returns the last blank before which a line fits, or its first blank; 0 if it has none. */
  private static int breakAt(String line, ToIntFunction<String> width, double maxWidth) {
    int at = Math.max(0, line.indexOf(' '));
    for (int blank = at; blank > 0; blank = line.indexOf(' ', blank + 1)) {
      if (width.applyAsInt(line.substring(0, blank)) <= maxWidth) {
        at = blank;
      }
    }
    return at;
  }
}
