package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;

class LandmarkFilesTest {
  private static final List<Landmark> LANDMARKS =
      List.of(
          new Landmark("nasion", new Vec3(1.5, -2, 0.1)),
          new Landmark("left, \"inner\" ear", new Vec3(1e-7, 3, 4)));

  @TempDir private Path folder;

  @Test
  void writesATableWithNamesQuotedWhereTheyMustBe() throws IOException {
    Path file = folder.resolve("l.csv");
    LandmarkFiles.writeCsv(file, LANDMARKS);
    assertEquals(
        List.of("name,x,y,z", "nasion,1.5,-2.0,0.1", "\"left, \"\"inner\"\" ear\",1.0E-7,3.0,4.0"),
        Files.readAllLines(file));
  }

  @Test
  void writesMarkupsThatSlicerOpens() throws IOException {
    Path file = folder.resolve("l.fcsv");
    LandmarkFiles.writeFcsv(file, LANDMARKS);
    List<String> lines = Files.readAllLines(file);
    assertEquals("# CoordinateSystem = LPS", lines.get(1));
    assertEquals("vtkMRMLMarkupsFiducialNode_0,1.5,-2.0,0.1,0,0,0,1,1,1,0,nasion,,", lines.get(3));
  }
}
