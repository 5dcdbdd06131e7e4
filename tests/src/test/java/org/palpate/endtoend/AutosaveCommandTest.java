package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Kills a session while it runs, and goes on from what it saved. */
class AutosaveCommandTest {
  private static final String PHANTOM = "fracture:64:3";
  private static final String SAVED = "fracture-64-3-1-1.autosave.json";
  private static final String SECOND = "fracture-64-3-1-1.autosave2.json";

  @TempDir private Path folder;

  private Path still;

  @BeforeEach
  void recordAHandThatStaysAway() throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int ms = 0; ms < 500; ms++) {
      rows.append(ms).append(",-30,-30,-30\n");
    }
    still = Files.writeString(folder.resolve("still.csv"), rows);
  }

  /** Starts a session in the folder. */
  private ProcessBuilder touch(Object... arguments) {
    Object[] all =
        Stream.concat(Stream.of("touch", "--headless"), Arrays.stream(arguments)).toArray();
    return CommandRun.inOwnJvm(Path.of(System.getProperty("java.home")), List.of(), all)
        .directory(folder.toFile());
  }

  private CommandRun touchAway(Object... arguments) throws IOException, InterruptedException {
    Object[] device = {"--device", "replay:" + still};
    return CommandRun.waitFor(
        touch(Stream.concat(Arrays.stream(device), Arrays.stream(arguments)).toArray()));
  }

  private List<String> left() throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(file -> file.getFileName().toString())
          .filter(name -> name.startsWith("fracture-"))
          .sorted()
          .toList();
    }
  }

  @Test
  void aSessionThatIsKilledGoesOnFromWhereItsFragmentsWere()
      throws IOException, InterruptedException {
    Path saved = folder.resolve(SAVED);
    Process first =
        touch("--phantom", PHANTOM)
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("first.txt").toFile())
            .start();
    try {
      for (int tick = 0; tick < 900 && !Files.exists(saved); tick++) {
        assertTrue(first.isAlive(), () -> "it ended: " + read("first.txt"));
        TimeUnit.MILLISECONDS.sleep(100);
      }
      assertTrue(Files.exists(saved));
      CommandRun beside = touchAway("--phantom", PHANTOM).mustSucceed();
      assertTrue(beside.out().contains("saved as " + SECOND), beside.out());
      assertFalse(beside.out().contains("resumes it"), "the first still runs: " + beside.out());
    } finally {
      first.destroyForcibly();
    }
    first.waitFor();
    assertTrue(read("first.txt").contains("saved as " + SAVED + "."), read("first.txt"));
    CommandRun again = touchAway("--phantom", PHANTOM).mustSucceed();
    assertTrue(again.out().contains("--scene " + SAVED + " resumes it"), again.out());
    Path end = folder.resolve("end.json");
    CommandRun resumed = touchAway("--scene", SAVED, "--save-scene", end).mustSucceed();
    assertTrue(
        resumed.out().contains("saved as " + folder.resolve("end.autosave.json")), resumed.out());
    assertFalse(resumed.out().contains("resumes it"), resumed.out());
    assertEquals(poses(saved), poses(end), "to the bit");
    Path fresh = folder.resolve("fresh.json");
    CommandRun.of(
            "info",
            "--phantom",
            PHANTOM,
            "--export",
            folder.resolve("fresh.nrrd"),
            "--save-scene",
            fresh)
        .mustSucceed();
    assertFalse(poses(fresh).equals(poses(saved)), "the hand has moved a fragment");
    assertEquals(List.of(SAVED, SAVED.replace("json", "nrrd")), left());
  }

  /** Returns the numbers of all poses of a scene file. */
  private static Map<String, String> poses(Path scene) throws IOException {
    Map<String, String> numbers = FlatJson.read(scene);
    numbers.keySet().removeIf(key -> !key.contains("/pose/"));
    assertEquals(3 * 7, numbers.size());
    return numbers;
  }

  @Test
  void damagedFilesAreRefusedInOneLine() throws IOException {
    Path scene = folder.resolve("jaw.autosave.json");
    Path volume = folder.resolve("jaw.autosave.nrrd");
    Path groups = folder.resolve("jaw.autosave.groups.csv");
    CommandRun.of("info", "--phantom", PHANTOM, "--export", volume, "--save-scene", scene)
        .mustSucceed();
    byte[] whole = Files.readAllBytes(scene);
    for (int length : new int[] {0, 1, whole.length / 2, whole.length - 3}) {
      Files.write(scene, Arrays.copyOf(whole, length));
      assertRefused(scene, scene);
    }
    Files.write(scene, whole);
    Files.writeString(groups, "body,group,locked\nfragment2,1\n");
    assertRefused(scene, groups);
    Files.delete(groups);
    byte[] voxels = Files.readAllBytes(volume);
    Files.write(volume, Arrays.copyOf(voxels, voxels.length - 100));
    assertRefused(scene, volume);
    Files.delete(volume);
    assertRefused(scene, volume);
  }

  private void assertRefused(Path scene, Path named) {
    String line =
        CommandRun.of("touch", "--scene", scene, "--headless", "--seconds", 0.1).mustRefuse();
    assertTrue(line.contains(named.toString()), line);
  }

  private String read(String name) {
    try {
      return Files.readString(folder.resolve(name));
    } catch (IOException e) {
      return e.toString();
    }
  }
}
