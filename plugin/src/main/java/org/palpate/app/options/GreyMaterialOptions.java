package org.palpate.app.options;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.force.GreyMaterials;
import org.palpate.io.table.NumbersCsvReader;
import picocli.CommandLine.Option;

/** The option of materials that follow from grey values. */
public final class GreyMaterialOptions {
  private static final String OPTION = "--material-from-grey ";
  private static final String CT = "ct";
  private static final List<String> COLUMNS = List.of("grey", "stiffness", "friction", "damping");
  private static final double[] MOST = {Double.MAX_VALUE, 10, 100, 1e6};
  private static final int MOST_ROWS = 100;

  @Option(
      names = "--material-from-grey",
      paramLabel = "TABLE|ct",
      description = {
        "Takes stiffness, friction and damping from the grey value under the contact: ct (for"
            + " Hounsfield units) or a table with columns grey,stiffness,friction,damping, where"
            + " stiffness is a factor of the stiffness of contact."
      })
  private String table;

  /** Whether materials follow from grey values. */
  boolean areWanted() {
    return table != null;
  }

  /** Returns the file of the table, if there is one. */
  Optional<Path> file() {
    try {
      return areWanted() && !table.equals(CT) ? Optional.of(Path.of(table)) : Optional.empty();
    } catch (InvalidPathException e) {
      throw PalpateException.wrongUse(
          "the name is no file", OPTION + table, "write ct or a file", e);
    }
  }

  /**
   * Refuses what does not go together.
   *
   * @throws PalpateException exit code 2
   */
  void check(ContactOptions contact) {
    file();
    if (areWanted() && contact.hasMaterials()) {
      throw PalpateException.wrongUse(
          "materials come from segments or from grey values",
          "--material with " + OPTION.strip(),
          "leave one of them out");
    }
  }

  /**
   * Returns the materials, if they follow from grey values.
   *
   * @throws IOException if a file cannot be read
   * @throws PalpateException exit code 2, if the table or the volume does not suit
   */
  Optional<GreyMaterials> materials(VolumeSource source) throws IOException {
    if (!areWanted()) {
      return Optional.empty();
    }
    if (source.firstThreshold().isEmpty() || !source.placements().isEmpty()) {
      throw PalpateException.wrongUse(
          "materials from grey values need a volume of grey values",
          OPTION + table,
          "choose segments by a threshold, as in --segment 'bone=>=300'");
    }
    List<GreyMaterials.Row> rows = table.equals(CT) ? GreyMaterials.CT : rows(Path.of(table));
    return Optional.of(new GreyMaterials(source.greyValues(), rows));
  }

  private static List<GreyMaterials.Row> rows(Path file) throws IOException {
    List<GreyMaterials.Row> rows = new ArrayList<>();
    for (double[] row : NumbersCsvReader.read(file, COLUMNS)) {
      checkRow(file, row, rows);
      rows.add(new GreyMaterials.Row(row[0], row[1], row[2], row[3]));
    }
    if (rows.isEmpty() || rows.size() > MOST_ROWS) {
      throw PalpateException.wrongUse(
          "a table of materials has 1 to 100 rows and this one has " + rows.size(),
          file.toString(),
          "leave out rows, or add some");
    }
    return rows;
  }

  private static void checkRow(Path file, double[] row, List<GreyMaterials.Row> before) {
    String where = file + " row " + (before.size() + 1);
    for (int n = 1; n < row.length; n++) {
      if (!(row[n] >= 0 && row[n] <= MOST[n])) {
        throw PalpateException.wrongUse(
            COLUMNS.get(n) + " is " + row[n],
            where,
            "write a stiffness from 0 to 10, friction from 0 to 100, damping from 0 to 1,000,000");
      }
    }
    if (!before.isEmpty() && !(row[0] > before.get(before.size() - 1).grey())) {
      throw PalpateException.wrongUse("grey values do not rise", where, "sort the rows");
    }
  }
}
