package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;

/** Settings that a scene file gives its bodies and its tool, in a replay. */
class SceneSettingsTest {
  @TempDir private Path folder;

  /**
   * Returns the report of a replay that presses a block of two halves, "a" and "b", without the
   * digest of its files.
   */
  private Map<String, String> press(String scene, Object... options) throws IOException {
    Path volume = folder.resolve("block.nrrd");
    if (!Files.exists(volume)) {
      TestFiles.nrrd(volume, 24, v -> v[2] >= 12 ? 0 : v[0] < 12 ? 1 : 2);
    }
    Vec3 at =
        VolumeFiles.open(volume, ReadOptions.defaults())
            .header()
            .grid()
            .gridToWorld(new Vec3(6, 12, 12), new Vec3());
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 300; n++) {
      rows.append(n).append(',').append(at.x).append(',').append(at.y).append(',');
      rows.append(at.z + 8 - Math.min(n, 150) * 0.08).append('\n');
    }
    Path trajectory = Files.writeString(folder.resolve("press.csv"), rows);
    Path file = Files.writeString(folder.resolve("press.json"), scene);
    Path report = folder.resolve("press-report.json");
    List<Object> args = new ArrayList<>(List.of("replay", "--scene", file));
    args.addAll(List.of("--trajectory", trajectory, "--report", report));
    args.addAll(List.of(options));
    CommandRun.of(args.toArray()).mustSucceed();
    Map<String, String> fields = new TreeMap<>(FlatJson.read(report));
    fields.remove("/sha256");
    return fields;
  }

  private static String blocks(String further, String ofA) {
    String volume = "\"volume\": \"block.nrrd\", \"segment\": \"label:";
    return "{\"tool\": {\"spec\": \"sphere:2\"}, "
        + further
        + "\"bodies\": [{\"name\": \"a\", "
        + ofA
        + volume
        + "1\"}, {\"name\": \"b\", "
        + volume
        + "2\"}]}";
  }

  @Test
  void materialsCuttingAndMarginsOfASceneAreThoseOfTheOptions() throws IOException {
    String plain = press(blocks("", "")).get("/max_force_n");
    String soft = press(blocks("", "\"material\": \"stiffness:0.1\", ")).get("/max_force_n");
    String option = press(blocks("", ""), "--material", "a=stiffness:0.1").get("/max_force_n");
    assertEquals(option, soft);
    assertTrue(Double.parseDouble(soft) < 0.5 * Double.parseDouble(plain), soft + " " + plain);
    Map<String, String> cut = press(blocks("\"carve\": 400, ", ""));
    assertEquals(press(blocks("", ""), "--carve", 400), cut);
    assertTrue(Double.parseDouble(cut.get("/carved/a")) > 10, cut.toString());
    Map<String, String> spared = press(blocks("\"carve\": 400, \"protect\": [\"a\"], ", ""));
    assertEquals(press(blocks("", ""), "--carve", 400, "--protect", "a"), spared);
    assertEquals(0, Double.parseDouble(spared.get("/carved/a")), spared.toString());
    String moved = "\"pose\": {\"translation_mm\": [1, 0, 0], \"rotation\": [1, 0, 0, 0]}, ";
    Path file = folder.resolve("moved.json");
    Files.writeString(file, blocks("\"protect\": [\"a\"], ", moved));
    String refusal =
        CommandRun.of("replay", "--scene", file, "--trajectory", folder.resolve("press.csv"))
            .mustRefuse();
    assertTrue(refusal.contains("margins are for bodies of one grid that are fixed"), refusal);
  }

  @Test
  void aClearanceThatIsGivenReplacesThatOfTheScene() throws IOException {
    String plain = blocks("", "");
    String wide = plain.replace("\"sphere:2\"", "\"sphere:2\", \"clearance\": 0.5");
    Map<String, String> own = press(wide);
    assertEquals(0.5, Double.parseDouble(own.get("/tool/clearance_mm")));
    assertEquals(own, press(plain, "--clearance", 0.5));
    assertEquals(press(plain), press(wide, "--clearance", "body"));
  }
}
