package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.scene.OpenedScene;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneReader;

class SceneAutosaveTest {
  private static final long PERIOD = SceneAutosave.PERIOD_NANOS;

  @TempDir private Path folder;

  private final Pose pose = new Pose();
  private Path scene;
  private Path saved;
  private SceneAutosave autosave;

  @BeforeEach
  void startASession() throws IOException {
    scene = Files.createDirectory(folder.resolve("in")).resolve("jaw.json");
    Files.writeString(
        scene,
        """
        {"bodies": [{"name": "a", "volume": "scans/jaw.nrrd", "segment": "label:1",
                     "mobility": "movable", "material": "friction:0.1"}],
         "tool": {"spec": "burr.stl"}, "carve": 20}
        """);
    saved = folder.resolve("end.autosave.json");
    autosave =
        new SceneAutosave(
            new OpenedScene(SceneReader.read(scene), scene),
            saved,
            () -> List.of(pose.transform(RigidTransform.identity())),
            0);
  }

  @Test
  void aMovedBodyIsSavedOnceAPeriodAndTheEndDeletesIt() throws IOException {
    autosave.tick(PERIOD - 1);
    assertFalse(Files.exists(saved));
    pose.translation.set(1, 2, 3);
    pose.rotation.setRotationVector(new Vec3(0.1, 0.2, -0.3));
    autosave.tick(PERIOD);
    SceneFile found = SceneReader.read(saved);
    Pose back = found.bodies().get(0).pose();
    assertTrue(back.translation.sameBits(pose.translation));
    assertEquals(1, Math.abs(back.rotation.dot(pose.rotation)), 1e-15);
    assertEquals("in/scans/jaw.nrrd", found.bodies().get(0).source());
    assertEquals("in/burr.stl", found.tool().orElseThrow().spec());
    assertEquals(Optional.of("friction:0.1"), found.bodies().get(0).material());
    assertEquals(20, found.carve().orElseThrow());
    Files.delete(saved);
    autosave.tick(2 * PERIOD);
    assertFalse(Files.exists(saved), "nothing moved since");
    pose.translation.x = 4;
    autosave.tick(3 * PERIOD);
    assertEquals(4, SceneReader.read(saved).bodies().get(0).pose().translation.x);
    autosave.end();
    assertFalse(Files.exists(saved));
  }

  @Test
  void whatACrashLeftIsNamedAndNotReplaced() throws IOException {
    Optional<Path> end = Optional.of(folder.resolve("end.json"));
    Optional<Path> start = Optional.of(scene);
    assertEquals(Optional.empty(), SceneAutosave.note(start, end));
    Files.writeString(folder.resolve("end.autosave.json.txt"), "of another program");
    Files.writeString(folder.resolve("end.autosave1.json"), "of another program");
    assertEquals(Optional.empty(), SceneAutosave.note(start, end));
    assertEquals(saved, target(end));
    Files.writeString(saved, "left");
    assertTrue(SceneAutosave.note(start, end).orElseThrow().contains(saved.toString()));
    assertEquals(folder.resolve("end.autosave2.json"), target(end));
    assertEquals(Optional.empty(), SceneAutosave.of(start, Optional.empty(), List::of));
    assertEquals(Optional.empty(), SceneAutosave.of(Optional.empty(), end, List::of));
  }

  private Path target(Optional<Path> end) throws IOException {
    return SceneAutosave.of(Optional.of(scene), end, List::of).orElseThrow().target();
  }

  /** A session that resumed the first one has crashed too. */
  @Test
  void ofSeveralCrashesTheLastIsNamedAndNotAgainWhileItIsResumed() throws IOException {
    Optional<Path> end = Optional.of(folder.resolve("end.json"));
    Path second = folder.resolve("end.autosave2.json");
    Files.writeString(saved, "left");
    Files.writeString(second, "left");
    String note = SceneAutosave.note(Optional.of(saved), end).orElseThrow();
    assertTrue(note.contains(second.toString()), note);
    Path indirect = folder.resolve("in").resolve("..").resolve("end.autosave2.json");
    assertEquals(Optional.empty(), SceneAutosave.note(Optional.of(indirect), end));
    Files.delete(saved);
    note = SceneAutosave.note(Optional.of(scene), end).orElseThrow();
    assertTrue(note.contains(second.toString()), note);
    assertEquals(folder.resolve("end.autosave3.json"), target(end), "the last has the highest");
  }
}
