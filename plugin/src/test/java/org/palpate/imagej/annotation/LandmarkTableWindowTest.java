package org.palpate.imagej.annotation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.gui.PointRoi;
import ij.gui.Roi;
import ij.gui.TextRoi;
import ij.measure.ResultsTable;
import java.awt.Window;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.Stacks;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.window.TestDisplay;

class LandmarkTableWindowTest {
  @TempDir private Path folder;

  private final ImagePlus image = Stacks.of(8, 10, 8, 6, (i, j, k) -> 0);
  private final List<String> seen = new ArrayList<>();

  @BeforeEach
  void calibrate() {
    TestDisplay.require();
    image.getCalibration().setUnit("cm");
    image.getCalibration().pixelWidth = 0.05;
    image.getCalibration().pixelHeight = 0.1;
    image.getCalibration().pixelDepth = 0.2;
  }

  @AfterEach
  void closeTheTable() {
    for (Window window : Window.getWindows()) {
      window.dispose();
    }
    ij.WindowManager.closeAllWindows();
  }

  private LandmarkTable table() throws TouchRefusedException {
    return new LandmarkTable(image, StackGeometry.of(image), this::show);
  }

  private void show(List<NamedPoint> all) {
    seen.clear();
    all.forEach(point -> seen.add(point.name() + " " + point.position()));
  }

  @Test
  void aLandmarkIsARowAMarkAndAPointOfTheView() throws TouchRefusedException {
    LandmarkTable table = table();
    assertEquals("L1", table.nextName());
    table.add("L1", new Vec3(4, 2, 3));
    table.add("tip", new Vec3(1, 1, 99));
    assertEquals("L3", table.nextName());
    assertEquals(List.of("L1 (2.0, 2.0, 6.0)", "tip (0.5, 1.0, 198.0)"), seen);
    ResultsTable rows = ResultsTable.getResultsTable(LandmarkTable.TITLE);
    int last = rows.size() - 1;
    assertEquals("tip", rows.getStringValue("Name", last));
    assertEquals(0.2, rows.getValue("X", last - 1), 1e-12);
    assertEquals(0.2, rows.getValue("Y", last - 1), 1e-12);
    assertEquals(0.6, rows.getValue("Z", last - 1), 1e-12);
    assertEquals("cm", rows.getStringValue("Unit", last));
    Roi[] marks = image.getOverlay().toArray();
    assertEquals(4, marks.length, "a point and a name each");
    assertTrue(marks[0] instanceof PointRoi && marks[1] instanceof TextRoi);
    assertEquals(4, marks[0].getPosition(), "grid 3 lies at the beginning of slice 4");
    assertEquals(4, marks[1].getPosition());
    assertEquals(6, marks[2].getPosition(), "no slice lies beyond the last");
  }

  @Test
  void aMarkOfAHyperstackIsSeenInAllChannels() throws TouchRefusedException {
    image.setDimensions(2, 3, 1);
    image.setOpenAsHyperStack(true);
    LandmarkTable table = table();
    table.add("a", new Vec3(1, 1, 1.5));
    Roi mark = image.getOverlay().get(0);
    assertEquals(image.isHyperStack() ? 0 : 2, mark.getCPosition());
    assertEquals(2, image.isHyperStack() ? mark.getZPosition() : mark.getPosition());
  }

  @Test
  void landmarksAreSavedInWorldMillimetres() throws TouchRefusedException, IOException {
    LandmarkTable table = table();
    table.add("a", new Vec3(4, 2, 3));
    table.save(folder);
    assertEquals(
        List.of("name,x,y,z", "a,2.0,2.0,6.0"),
        Files.readAllLines(folder.resolve("landmarks.csv")));
    assertTrue(Files.readString(folder.resolve("landmarks.fcsv")).contains(",2.0,2.0,6.0,"));
    Path none = folder.resolve("none");
    TouchRefusedException refusal =
        assertThrows(TouchRefusedException.class, () -> table.save(none));
    assertEquals("The landmarks cannot be saved in " + none + ": NoSuchFile", refusal.getMessage());
  }
}
