package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.body.BodyEvent;
import org.palpate.device.DeviceState;
import org.palpate.elastic.UpdateListener;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

class TrajectoryRecordingTest {
  @TempDir private Path folder;

  private Path older(String name) throws IOException {
    return Files.writeString(folder.resolve(name), "older");
  }

  @Test
  void withoutASampleAllFilesOfAnOlderRecordingStay() throws IOException {
    List<Path> files =
        List.of(older("t.csv"), older("t.edits.csv"), older("t.poses.csv"), older("t.fields.csv"));
    try (TrajectoryRecording recording = new TrajectoryRecording(files.get(0), List.of("bone"))) {
      recording.editRecorder().offer(0, 0, 1, 2, 3, false);
      recording.bodyRecorder().offer(0, 0, BodyEvent.MOVED, new Pose(), new Pose());
      recording.finish();
    }
    for (Path file : files) {
      assertEquals("older", Files.readString(file), file.toString());
    }
    try (var left = Files.list(folder)) {
      assertEquals(4, left.count());
    }
  }

  @Test
  void eachTableIsReplacedOrDeletedTogetherWithTheSamples() throws IOException {
    Path samples = older("t.csv");
    Path edits = older("t.edits.csv");
    Path poses = older("t.poses.csv");
    Path fields = older("t.fields.csv");
    try (TrajectoryRecording recording = new TrajectoryRecording(samples, List.of("bone"))) {
      recording.recorder().offer(new DeviceState());
      recording.bodyRecorder().offer(0, 0, BodyEvent.MOVED, new Pose(), new Pose());
      recording.finish();
    }
    assertTrue(Files.readString(samples).startsWith("t_ms,"));
    assertTrue(Files.readString(poses).contains("\n0,bone,"), Files.readString(poses));
    assertFalse(Files.exists(edits));
    assertFalse(Files.exists(fields));
  }

  @Test
  void aRecordingThatLostUpdatesOfElasticSegmentsSaysSoAtItsEnd() throws IOException {
    int moreThanFit = 1 << 22;
    Path samples = folder.resolve("t.csv");
    try (TrajectoryRecording recording = new TrajectoryRecording(samples, List.of("bone"))) {
      recording.recorder().offer(new DeviceState());
      UpdateListener updates = recording.fieldRecorder().listener(() -> 0);
      CellStiffness soft = new CellStiffness(1, 1, 1, 1, 1);
      for (int cell = 0; cell < moreThanFit; cell++) {
        updates.refilled(cell, soft);
      }
      updates.updating(new Vec3(), new Vec3());
      updates.updating(new Vec3(), new Vec3());
      IOException loss = assertThrows(IOException.class, recording::finish);
      assertEquals(
          "2 updates of elastic segments were lost; a replay would differ", loss.getMessage());
    }
    assertTrue(Files.exists(samples), "what was recorded stays");
  }
}
