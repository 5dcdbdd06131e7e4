package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Cuts with the commands, and replays what was cut. */
class CarveCommandTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"sphere:2", "point"})
  void aRecordedSessionReplaysToTheSameVoxelsAndCarvedIsWhatIsMissing(String tool)
      throws IOException {
    Path recording = folder.resolve("t.csv");
    Path live = folder.resolve("live.nrrd");
    Path again = folder.resolve("again.nrrd");
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--tool", tool, "--carve", 400, "--seconds", 2, "--record", recording));
    touch.addAll(List.of("--export", live, "--report", report));
    CommandRun.of(touch.toArray()).mustSucceed();
    double carved = carved(report);
    assertTrue(carved > 3, "carved " + carved);
    Path edits = folder.resolve("t.edits.csv");
    assertEquals(carved, Files.readAllLines(edits).size() - 1.0, "voxels of 1 mm^3");
    assertEquals((long) carved, voxels("--phantom", "sphere:32") - voxels("--volume", live));

    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--tool", tool, "--trajectory", recording, "--edits", edits));
    replay.addAll(List.of("--export", again, "--report", report));
    CommandRun.of(replay.toArray()).mustSucceed();
    assertArrayEquals(Files.readAllBytes(live), Files.readAllBytes(again));
    assertEquals(carved, carved(report));
  }

  private static double carved(Path report) throws IOException {
    return FlatJson.number(report, "carved/sphere");
  }

  private static long voxels(Object... volume) {
    List<Object> info = new ArrayList<>(List.of("info"));
    info.addAll(List.of(volume));
    String out = CommandRun.of(info.toArray()).mustSucceed().out();
    Matcher found = Pattern.compile("segment +sphere: ([0-9,]+) voxels").matcher(out);
    assertTrue(found.find(), out);
    return Long.parseLong(found.group(1).replace(",", ""));
  }

  @Test
  void aReplayThatCutsGivesTheSameBytesEveryTime() throws IOException {
    Path trajectory = Files.writeString(folder.resolve("t.csv"), press());
    byte[][] frames = new byte[2][];
    byte[][] voxels = new byte[2][];
    for (int n = 0; n < 2; n++) {
      Path out = folder.resolve("f.csv");
      Path export = folder.resolve("cut.nrrd");
      List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
      replay.addAll(List.of("--tool", "sphere:2", "--carve", 30, "--trajectory", trajectory));
      replay.addAll(List.of("--out", out, "--export", export));
      CommandRun.of(replay.toArray()).mustSucceed();
      frames[n] = Files.readAllBytes(out);
      voxels[n] = Files.readAllBytes(export);
    }
    assertArrayEquals(frames[0], frames[1]);
    assertArrayEquals(voxels[0], voxels[1]);
  }

  private static String press() {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 600; n++) {
      rows.append(n).append(",16,16,").append(32 - n * 0.03).append('\n');
    }
    return rows.toString();
  }

  @ParameterizedTest
  @ValueSource(strings = {"point", "sphere:2"})
  void passesAreNotTimedIfTheFirstOneChangesVoxels(String tool) throws IOException {
    Path trajectory = Files.writeString(folder.resolve("t.csv"), press());
    Path edits =
        Files.writeString(
            folder.resolve("e.csv"),
            "frame,body,segment,i,j,k,solid\n0,sphere,sphere,16,16,16,0\n");
    List<Object> replay = List.of("replay", "--phantom", "sphere:32", "--tool", tool);
    for (List<Object> changing :
        List.<List<Object>>of(List.of("--edits", edits), List.of("--carve", 40))) {
      List<Object> timed = new ArrayList<>(replay);
      timed.addAll(List.of("--trajectory", trajectory, "--repeat", 3));
      timed.addAll(changing);
      String line = CommandRun.of(timed.toArray()).mustRefuse();
      assertTrue(line.contains("a pass would not begin where the last one did: "), line);
      assertTrue(line.contains("--repeat with " + changing.get(0) + ": "), line);
    }
  }

  @Test
  void aDicomExportHasEachEditedSegmentWhole() throws IOException {
    Path scan = folder.resolve("scan.nrrd");
    CommandRun.of("info", "--phantom", "sphere:32:grey", "--export", scan).mustSucceed();
    SegmentedVolume expected = segments(scan, "soft=>=200", "hard=>=700");
    StringBuilder edits = new StringBuilder("frame,body,segment,i,j,k,solid\n");
    for (int n = 6; n < 20; n++) {
      for (Segment segment : expected.segments()) {
        int k = segment.name().equals("soft") ? 16 : 17;
        boolean solid = !segment.bits().get(n, 16, k);
        setVoxel(segment.bits(), n, 16, k, solid);
        edits.append(String.format("%d,%s,%2$s,%1$d,16,%d,", n, segment.name(), k));
        edits.append(solid ? 1 : 0).append('\n');
      }
    }
    Path export = folder.resolve("left.dcm");
    List<Object> replay = new ArrayList<>(List.of("replay", "--volume", scan));
    replay.addAll(List.of("--segment", "soft=>=200", "--segment", "hard=>=700"));
    replay.addAll(List.of("--trajectory", Files.writeString(folder.resolve("t.csv"), press())));
    replay.addAll(List.of("--edits", Files.writeString(folder.resolve("e.csv"), edits)));
    replay.addAll(List.of("--export", export));
    CommandRun.of(replay.toArray()).mustSucceed();
    SegmentedVolume read = segments(export, "soft=name:soft", "hard=name:hard");
    int firstSlice = (int) read.grid().gridToWorld(new Vec3(), new Vec3()).z;
    for (int n = 0; n < 2; n++) {
      BitCube left = read.segments().get(n).bits();
      BitCube bits = expected.segments().get(n).bits();
      for (int voxel = 0; voxel < 32 * 32 * 32; voxel++) {
        int i = voxel % 32;
        int j = voxel / 32 % 32;
        int k = voxel / 32 / 32;
        assertEquals(bits.get(i, j, k), left.get(i, j, k - firstSlice), i + " " + j + " " + k);
      }
    }
  }

  private static void setVoxel(BitCube bits, int i, int j, int k, boolean solid) {
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
  }

  private static SegmentedVolume segments(Path file, String... specs) throws IOException {
    List<SegmentSpec> parsed = new ArrayList<>();
    for (String spec : specs) {
      parsed.add(SegmentSpec.parse(spec));
    }
    return SegmentBuilder.read(VolumeFiles.open(file, ReadOptions.defaults()), parsed);
  }

  @Test
  void aFullDiskAtTheExportIsOneLineAndKeepsTheReport() throws IOException {
    Path target = Files.createSymbolicLink(folder.resolve("full.nrrd"), Path.of("/dev/full"));
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--carve", 40, "--seconds", 0.3));
    touch.addAll(List.of("--export", target, "--report", report));
    CommandRun run = CommandRun.of(touch.toArray());
    assertEquals(1, run.exitCode());
    assertEquals(
        "palpate: could not be written (No space left on device): "
            + target
            + ": check the disk and its permissions",
        run.err().strip());
    assertTrue(Files.size(report) > 100);
  }

  private CommandRun record(Path recording) {
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:16", "--headless"));
    touch.addAll(List.of("--seconds", 0.3, "--record", recording));
    return CommandRun.of(touch.toArray());
  }

  @Test
  void aSessionWithoutACutOrAMotionLeavesNoTableOfEditsOrPoses() throws IOException {
    Path recording = folder.resolve("t.csv");
    Path edits = Files.writeString(folder.resolve("t.edits.csv"), "of an older recording");
    Path poses = Files.writeString(folder.resolve("t.poses.csv"), "of an older recording");
    record(recording).mustSucceed();
    assertTrue(Files.exists(recording));
    assertFalse(Files.exists(edits));
    assertFalse(Files.exists(poses));
  }

  @Test
  void theTableOfEditsNeverReplacesAnInput() throws IOException {
    Path played = Files.writeString(folder.resolve("t.edits.csv"), press());
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--device", "replay:" + played, "--record", folder.resolve("t.csv")));
    assertTrue(CommandRun.of(touch.toArray()).mustRefuse().contains("the target is an input"));
    assertEquals(press(), Files.readString(played));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "frame,body,segment,i,j,k\n0,sphere,sphere,1,1,1 => there is no column solid",
        "frame,body,segment,i,j,k,solid\n0,sphere,ball,1,1,1,0 => there is no segment ball",
        "frame,body,segment,i,j,k,solid\n0,ball,sphere,1,1,1,0 => the body of segment sphere",
        "frame,body,segment,i,j,k,solid\n0,sphere,sphere,1,99,1,0 => j is 99",
        "frame,body,segment,i,j,k,solid\n-1,sphere,sphere,1,1,1,0 => frame is -1",
        "frame,body,segment,i,j,k,solid\n0,sphere,sphere,1,1,1,2 => solid is 2",
        "frame,body,segment,i,j,k,solid\n0,sphere,sphere,1,1 => k is missing",
      })
  void aTableThatIsNotUnderstoodIsRefusedWithItsLine(String text) throws IOException {
    String[] parts = text.split(" => ", 2);
    Path edits = Files.writeString(folder.resolve("e.csv"), parts[0] + "\n");
    Path trajectory = Files.writeString(folder.resolve("t.csv"), press());
    String line =
        CommandRun.of(
                "replay", "--phantom", "sphere:32", "--trajectory", trajectory, "--edits", edits)
            .mustRefuse();
    assertTrue(line.startsWith("palpate: " + parts[1]), line);
    assertTrue(line.contains("e.csv line "), line);
  }

  @Test
  void outputsThatWouldHarmAnInputAreRefused() throws IOException {
    Path trajectory = Files.writeString(folder.resolve("t.csv"), press());
    Path edits = Files.writeString(folder.resolve("e.nrrd"), "frame,body,segment,i,j,k,solid\n");
    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--trajectory", trajectory, "--edits", edits, "--export", edits));
    assertTrue(CommandRun.of(replay.toArray()).mustRefuse().contains("the target is an input"));
    assertTrue(
        CommandRun.of("touch", "--headless", "--export", folder.resolve("x.stl"))
            .mustRefuse()
            .contains("cannot be written in this format"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"point", "sphere:3"})
  void theReportSaysWhatCameNearestToWhatIsProtectedAndWhen(String tool) throws IOException {
    Path trajectory = Files.writeString(folder.resolve("t.csv"), press());
    Path report = folder.resolve("r.json");
    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--tool", tool, "--trajectory", trajectory));
    replay.addAll(List.of("--protect", "sphere:1.5:2", "--report", report));
    CommandRun.of(replay.toArray()).mustSucceed();
    String json = Files.readString(report);
    assertTrue(json.contains("\"segment\" : \"sphere\""), json);
    assertTrue(json.contains("\"margin_mm\" : 1.5"), json);
    double mm = FlatJson.number(report, "nearest_mm");
    assertTrue(mm >= 1.5 - 1e-6 && mm < 4, "nearest " + mm);
    double seconds = FlatJson.number(report, "nearest_s");
    assertTrue(seconds > 0 && seconds < 1, "at " + seconds + " s");
  }

  @ParameterizedTest
  @ValueSource(strings = {"sphere:x", "sphere:1:x", ":1", "sphere:1:-2", "sphere:2000"})
  void aMarginThatCannotBeReadIsRefused(String protect) {
    List<Object> touch = List.of("touch", "--headless", "--seconds", 1, "--phantom", "sphere:32");
    List<Object> all = new ArrayList<>(touch);
    all.addAll(List.of("--protect", protect));
    String line = CommandRun.of(all.toArray()).mustRefuse();
    assertTrue(line.startsWith("palpate: the margin cannot be read: --protect "), line);
  }
}
