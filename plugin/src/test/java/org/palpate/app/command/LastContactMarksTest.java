package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class LastContactMarksTest {
  private static final int SIZE = 16;

  @TempDir private Path folder;

  private static ContactScene floor() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < SIZE * SIZE * 8; n++) {
      bits.set(n % SIZE, n / SIZE % SIZE, n / SIZE / SIZE);
    }
    return new ContactScene(
        new SegmentedVolume(
            VoxelGrid.ofUnitVoxels(SIZE, SIZE, SIZE), List.of(new Segment("floor", bits, 0))),
        ContactSettings.builder(SolverKind.GUARDED).stiffness(0.5).friction(0).build());
  }

  /** Returns the marks of a path through some heights, which moves by 0.1 mm along x a frame. */
  private TouchMarks marks(WorldAxes axes, double... heights) throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < heights.length; n++) {
      rows.append(n).append(',').append(4 + 0.1 * n).append(",8,").append(heights[n]).append('\n');
    }
    Path file = Files.writeString(folder.resolve("t.csv"), rows);
    SceneModel model = new SceneModel(axes, Theme.DARK);
    LastContactMarks.show(file, floor(), Optional.empty(), model);
    return model.state().marks().orElseThrow();
  }

  @Test
  void theLastFrameWithContactIsShown() throws IOException {
    TouchMarks marks = marks(WorldAxes.LPS, 9, 8.5, 7, 6, 9, 10);
    assertTrue(marks.contact());
    assertEquals(4.3, marks.device().x, 1e-9);
    assertEquals(6, marks.device().z, 1e-9);
    assertEquals(8, marks.point().z, 1e-5);
    assertEquals(1, marks.forceNewton().z, 1e-5);
  }

  @Test
  void withoutContactTheLastFrameIsShown() throws IOException {
    TouchMarks marks = marks(WorldAxes.LPS, 9, 10, 11);
    assertFalse(marks.contact());
    assertEquals(4.2, marks.device().x, 1e-9);
    assertEquals(List.of(), marks.trail());
  }

  @Test
  void theTrailIsThatOfTheLastContactWithPointsApart() throws IOException {
    double[] heights = new double[30];
    for (int n = 0; n < heights.length; n++) {
      heights[n] = n == 10 ? 12 : 7;
    }
    TouchMarks marks = marks(WorldAxes.LPS, heights);
    List<Vec3> trail = marks.trail();
    assertTrue(trail.get(0).x > 4.9, "the trail before the point went up is forgotten");
    for (int n = 1; n < trail.size(); n++) {
      double step = trail.get(n).x - trail.get(n - 1).x;
      assertTrue(step >= 0.3 - 1e-9 && step < 0.45, "step " + step);
    }
  }

  @Test
  void marksStandInTheFrameOfTheScene() throws IOException {
    TouchMarks lps = marks(WorldAxes.LPS, 9, 7);
    TouchMarks ras = marks(WorldAxes.RAS, 9, 7);
    assertEquals(-lps.device().x, ras.device().x);
    assertEquals(-lps.point().y, ras.point().y);
    assertEquals(lps.forceNewton().z, ras.forceNewton().z);
  }

  @ParameterizedTest
  @EnumSource(StandardView.class)
  void thePictureIsSeenFromTheSideThatWasTouched(StandardView view) {
    Vec3 middle = new Vec3(5, 6, 7);
    Vec3 outside = view.towardsEye().mul(3, new Vec3()).add(middle, new Vec3());
    assertEquals(view, LastContactMarks.viewOf(outside, middle));
  }

  @Test
  void aViewPrintsItsLinesAndEndsTheSession() {
    StringWriter said = new StringWriter();
    AtomicInteger stops = new AtomicInteger();
    ConsoleViewListener listener =
        new ConsoleViewListener(new PrintWriter(said), stops::incrementAndGet);
    listener.print("one");
    listener.stop();
    assertEquals("one" + System.lineSeparator(), said.toString());
    assertEquals(1, stops.get());
    assertEquals(List.of(), listener.landmarkLines());
  }
}
