package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.WriteFailures;
import org.palpate.body.BodyGroups;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.PlacedScenes;
import org.palpate.io.VolumeWriter;
import org.palpate.io.file.FileClaim;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.scene.AutosaveFiles;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SavedScene;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine;

class SessionAutosaveTest {
  @TempDir private Path folder;

  private final StringWriter lines = new StringWriter();
  private final StringWriter errors = new StringWriter();
  private WriteFailures failures = new WriteFailures(new PrintWriter(errors));
  private Path file;
  private VolumeSource source;
  private ToolScene scene;
  private TouchSession session;

  @BeforeEach
  void makeAScene() throws IOException {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(16, 16, 16);
    SegmentedVolume volume =
        new SegmentedVolume(grid, List.of(voxel("low", 2), voxel("high", 12), voxel("top", 14)));
    VolumeWriter.write(
        new SegmentsAsLabels(volume, CoordinateSystem.LPS), folder.resolve("parts.nrrd"));
    file = scene("movable");
    source = open(file);
    scene = PlacedScenes.scene(source.placed().orElseThrow());
    session = PlacedScenes.session(scene);
  }

  private static Segment voxel(String name, int at) {
    BitCube bits = new BitCube(16, 16, 16);
    bits.set(8, 8, at);
    return new Segment(name, bits, 0x808080);
  }

  private Path scene(String mobility) throws IOException {
    String body = "{\"name\": \"%s\", \"volume\": \"parts.nrrd\", \"segment\": \"label:%d\"%s}";
    String moves = ", \"mobility\": \"" + mobility + "\"";
    return Files.writeString(
        folder.resolve(mobility + ".json"),
        "{\"bodies\": ["
            + String.format(body, "low", 1, "")
            + ","
            + String.format(body, "high", 2, moves)
            + ","
            + String.format(body, "top", 3, moves)
            + "]}");
  }

  private static VolumeSource open(Path scene) throws IOException {
    return VolumeSource.open(
        CommandLine.populateCommand(new VolumeOptions(), "--scene", scene.toString()));
  }

  @AfterEach
  void close() {
    session.close();
  }

  private Optional<SessionAutosave> begin(VolumeSource of, Optional<Path> end) throws IOException {
    return SessionAutosave.of(
        of, end, false, false, new PrintWriter(lines), new PrintWriter(errors));
  }

  /** Ends a session that was saved once with a body at 1 mm, and has left it at 2 mm. */
  private void endSaved(boolean writesResult, boolean byHand, boolean inOrder) throws IOException {
    PlacedVolume start = source.placed().orElseThrow();
    SavedScene target = AutosaveFiles.beside(file).claim();
    target.write(start.at(poses(1)), false, BodyGroups.none(3));
    assertEquals(1, savedX());
    SessionAutosave autosave =
        new SessionAutosave(
            start,
            Optional.empty(),
            false,
            writesResult,
            Optional.of(target),
            new PrintWriter(lines),
            new PrintWriter(errors));
    assertTrue(autosave.begin(session).isPresent());
    autosave.end(start.at(poses(2)), inOrder, byHand, failures);
    assertEquals("", errors.toString());
    assertFalse(FileClaim.isHeld(target.file()));
  }

  private static List<Pose> poses(double xMm) {
    return List.of(new Pose(), Pose.at(xMm, 0, 0), new Pose());
  }

  private double savedX() throws IOException {
    Path saved = folder.resolve("movable.autosave.json");
    return SceneReader.read(saved).bodies().get(1).pose().translation.x;
  }

  private void assertKept(double xMm) throws IOException {
    assertEquals(List.of("movable.autosave.json"), names());
    assertEquals(xMm, savedX());
    assertEquals(
        "The result was not saved: --scene "
            + folder.resolve("movable.autosave.json")
            + " goes on from it.",
        lines.toString().strip());
  }

  private List<String> names() throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(each -> each.getFileName().toString())
          .filter(name -> name.contains("autosave"))
          .sorted()
          .toList();
    }
  }

  @Test
  void aResultThatIsNotWrittenStaysInTheAutosave() throws IOException {
    endSaved(false, true, true);
    assertKept(2);
  }

  @Test
  void theAutosaveOfAResultThatIsWrittenIsDeleted() throws IOException {
    endSaved(true, true, true);
    assertEquals(List.of(), names());
    assertEquals("", lines.toString());
  }

  @Test
  void nobodyWantsWhatASimulatedHandOrARecordingDoes() throws IOException {
    endSaved(false, false, true);
    assertEquals(List.of(), names());
    assertEquals("", lines.toString());
  }

  @Test
  void aResultThatCannotBeWrittenStaysInTheAutosave() throws IOException {
    StringWriter full = new StringWriter();
    WriteFailures failed = new WriteFailures(new PrintWriter(full));
    failed.report(folder.resolve("reduced.json"), new IOException("No space left on device"));
    failures = failed;
    endSaved(true, true, true);
    assertKept(2);
  }

  @Test
  void afterAFailureTheLastSaveStays() throws IOException {
    endSaved(true, false, false);
    assertKept(1);
  }

  @Test
  void aSessionThatMovedNothingLeavesNothing() throws IOException {
    SessionAutosave autosave = begin(source, Optional.empty()).orElseThrow();
    assertTrue(autosave.begin(session).isPresent());
    PlacedVolume start = source.placed().orElseThrow();
    String said = lines.toString().strip();
    assertEquals(
        "While a body moves, the scene is saved as "
            + folder.resolve("movable.autosave.json")
            + ".",
        said);
    autosave.end(start, true, true, failures);
    assertEquals(List.of(), names());
    assertEquals(said, lines.toString().strip());
  }

  @Test
  void whatACrashLeftIsNamedOnceAndNotWhileItIsResumed() throws IOException {
    Path left = folder.resolve("movable.autosave.json");
    Files.copy(file, left);
    assertTrue(begin(source, Optional.of(folder.resolve("movable.json"))).isPresent());
    assertEquals(2, lines.toString().lines().count(), lines.toString());
    assertTrue(lines.toString().contains("--scene " + left + " resumes it"), lines.toString());
    assertTrue(lines.toString().contains("movable.autosave2.json"), lines.toString());
    lines.getBuffer().setLength(0);
    assertTrue(begin(open(left), Optional.empty()).isPresent());
    assertFalse(lines.toString().contains("resumes"), lines.toString());
    assertTrue(lines.toString().contains("movable.autosave3.json"), lines.toString());
  }

  @Test
  void theSceneThatWillBeWrittenNamesTheAutosave() throws IOException {
    assertTrue(begin(source, Optional.of(folder.resolve("end.json"))).isPresent());
    assertTrue(
        lines.toString().contains(folder.resolve("end.autosave.json").toString()),
        lines.toString());
    lines.getBuffer().setLength(0);
    Path missing = folder.resolve("missing").resolve("end.json");
    assertTrue(begin(source, Optional.of(missing)).isPresent());
    assertTrue(
        lines.toString().contains(folder.resolve("movable.autosave.json").toString()),
        "the next place that can be written to: " + lines);
  }

  @Test
  void locksAndGroupsBesideTheSceneHoldAgain() throws IOException {
    Path table = folder.resolve("movable.groups.csv");
    Files.writeString(table, "body,group,locked\nhigh,1,1\ntop,1,1\n");
    SessionAutosave autosave = begin(source, Optional.empty()).orElseThrow();
    assertTrue(autosave.begin(session).isPresent());
    ToolFrame frame = session.toolFrame().orElseThrow();
    assertTrue(frame.groups().moveTogether(1, 2));
    assertTrue(frame.groups().isLocked(2));
    frame.requestGroups(frame.groups().alone(2));
    assertFalse(autosave.groups().moveTogether(1, 2), "as the session changed them");
    Files.writeString(table, "body,group,locked\nlow,1,0\ntop,1,0\n");
    assertThrows(IOException.class, () -> begin(source, Optional.empty()));
  }

  @Test
  void aSceneWithoutMovableBodiesIsNotSaved() throws IOException {
    assertEquals(Optional.empty(), begin(open(scene("fixed")), Optional.empty()));
    assertEquals("", lines.toString());
  }
}
