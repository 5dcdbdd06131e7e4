package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.force.GreyMaterials;
import org.palpate.io.table.CsvFormatException;

class GreyMaterialOptionsTest {
  private static final String HEADER = "grey,stiffness,friction,damping\n";
  private static final String[] THRESHOLD = {"--phantom=sphere:16:grey", "--segment=s=>=500"};

  @TempDir private Path folder;

  private static GreyMaterialOptions options(String table) {
    return Given.options(new GreyMaterialOptions(), "--material-from-grey=" + table);
  }

  private GreyMaterialOptions table(String rows) throws IOException {
    return options(Files.writeString(folder.resolve("t.csv"), HEADER + rows).toString());
  }

  private static GreyMaterials materials(GreyMaterialOptions options) throws IOException {
    return options.materials(Given.source(THRESHOLD)).orElseThrow();
  }

  @Test
  void withoutTheOptionThereIsNothing() throws IOException {
    GreyMaterialOptions none = Given.options(new GreyMaterialOptions());
    assertFalse(none.areWanted());
    assertEquals(Optional.empty(), none.file());
    assertTrue(none.materials(Given.source("--phantom=sphere:16")).isEmpty());
    none.check(Given.options(new ContactOptions(), "--material=a=stiffness:1"));
  }

  @Test
  void ctIsATableAndNoFile() throws IOException {
    assertTrue(options("ct").areWanted());
    assertEquals(Optional.empty(), options("ct").file());
    assertEquals(1, materials(options("ct")).stiffest());
    assertEquals(
        Given.source(THRESHOLD).header().grid().toString(),
        materials(options("ct")).grid().toString());
  }

  @Test
  void aTableGivesEachGreyValueItsMaterial() throws IOException {
    GreyMaterialOptions options = table("0,0.25,0.1,0\n500,0,0,1000000\n900,10,100,0\n");
    assertEquals(Optional.of(folder.resolve("t.csv")), options.file());
    assertEquals(10, materials(options).stiffest());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "stiffness is 10.5|1|0,10.5,0,0",
        "stiffness is -0.1|1|0,-0.1,0,0",
        "friction is 100.5|2|0,1,0,0;1,1,100.5,0",
        "damping is 1000001.0|2|0,1,0,0;1,1,0,1000001"
      })
  void aNumberOutOfRangeIsRefusedWithItsRow(String what, int row, String rows) throws IOException {
    GreyMaterialOptions options = table(rows.replace(';', '\n') + "\n");
    Given.refuses(
        what
            + ": "
            + folder.resolve("t.csv")
            + " row "
            + row
            + ": write a stiffness from 0 to 10, friction from 0 to 100, damping from 0 to"
            + " 1,000,000",
        () -> materials(options));
  }

  @Test
  void greyValuesMustRise() throws IOException {
    GreyMaterialOptions options = table("0,1,0,0\n5,1,0,0\n5,1,0,0\n");
    Given.refuses(
        "grey values do not rise: " + folder.resolve("t.csv") + " row 3: sort the rows",
        () -> materials(options));
  }

  @Test
  void aTableHasOneToAHundredRows() throws IOException {
    GreyMaterialOptions none = table("");
    Given.refuses(
        "a table of materials has 1 to 100 rows and this one has 0: "
            + folder.resolve("t.csv")
            + ": leave out rows, or add some",
        () -> materials(none));
    StringBuilder rows = new StringBuilder();
    for (int n = 0; n < 100; n++) {
      rows.append(n).append(",1,0,0\n");
    }
    assertEquals(1, materials(table(rows.toString())).stiffest());
    GreyMaterialOptions many = table(rows.append("100,1,0,0\n").toString());
    assertTrue(
        assertThrows(RuntimeException.class, () -> materials(many))
            .getMessage()
            .contains("this one has 101"));
  }

  @Test
  void aMissingTableIsRefusedByItsReader() {
    GreyMaterialOptions options = options(folder.resolve("none.csv").toString());
    assertThrows(CsvFormatException.class, () -> materials(options));
  }

  @Test
  void materialsNeedAThresholdAndNoPoses() {
    String line =
        "materials from grey values need a volume of grey values: --material-from-grey ct: choose"
            + " segments by a threshold, as in --segment 'bone=>=300'";
    Given.refuses(line, () -> options("ct").materials(Given.source("--phantom=sphere:16")));
    Given.refuses(line, () -> options("ct").materials(Given.source("--phantom=fracture:64:2")));
  }

  @Test
  void materialsOfSegmentsAndOfGreyValuesDoNotGoTogether() {
    Given.refuses(
        "materials come from segments or from grey values: --material with --material-from-grey:"
            + " leave one of them out",
        () -> options("ct").check(Given.options(new ContactOptions(), "--material=a=stiffness:1")));
    options("ct").check(Given.options(new ContactOptions()));
  }

  @Test
  void aNameThatNoFileCanHaveIsRefused() {
    Given.refuses(
        "the name is no file: --material-from-grey a\0b: write ct or a file",
        () -> options("a\0b").check(Given.options(new ContactOptions())));
  }
}
