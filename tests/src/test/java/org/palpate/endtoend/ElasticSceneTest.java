package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Fills of elastic segments, and scene files with elastic bodies. */
class ElasticSceneTest {
  private static final int EDGE = 64;

  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Presses from the front, into the middle of the cheek of the head, or the top of the block. */
  @BeforeEach
  void writeTrajectories() throws IOException {
    StringBuilder cheek = new StringBuilder("t_ms,x,y,z\n");
    StringBuilder top = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 300; n++) {
      cheek.append(n).append(',').append(0.66 * EDGE).append(',');
      cheek.append(0.02 * EDGE + 0.04 * n).append(',').append(0.36 * EDGE).append('\n');
      top.append(n).append(",32.3,30.4,").append(52 - 0.04 * n).append('\n');
    }
    Files.writeString(file("cheek.csv"), cheek);
    Files.writeString(file("top.csv"), top);
  }

  private CommandRun replay(String trajectory, String suffix, Object... further) {
    List<Object> args = new ArrayList<>(List.of("replay", "--trajectory", file(trajectory)));
    args.addAll(List.of("--out", file("f" + suffix), "--report", file("r" + suffix)));
    args.addAll(List.of(further));
    return CommandRun.of(args.toArray());
  }

  private Map<String, String> report(String suffix) throws IOException {
    return FlatJson.read(file("r" + suffix));
  }

  private CommandRun head(String suffix, Object... further) {
    List<Object> args =
        new ArrayList<>(List.of("--phantom", "head:" + EDGE, "--fixed", "skull", "--lattice", 4));
    args.addAll(List.of("--elastic", "skin=young:20e3"));
    args.addAll(List.of(further));
    return replay("cheek.csv", suffix, args.toArray());
  }

  private double force(String suffix) throws IOException {
    return Double.parseDouble(report(suffix).get("/max_force_n"));
  }

  /** Returns the force of the last frame along y, away from the cheek. */
  private double lastForce(String suffix) throws IOException {
    List<String> rows = Files.readAllLines(file("f" + suffix));
    return -Double.parseDouble(rows.get(rows.size() - 1).split(",", -1)[9]);
  }

  @Test
  void theSkinOfTheHeadLiesOnTissueThatCannotBeTouched() throws IOException {
    head("usual").mustSucceed();
    head("soft", "--elastic", "tissue=young:1e3").mustSucceed();
    head("hard", "--elastic", "tissue=young:100e3").mustSucceed();
    long voxels = Long.parseLong(report("usual").get("/elastic/untouchable_voxels"));
    assertTrue(voxels > 10_000 && voxels < 90_000, "voxels " + voxels);
    double usual = lastForce("usual");
    assertTrue(usual > 1.5 * lastForce("soft"), lastForce("soft") + " " + usual);
    assertTrue(lastForce("hard") > 1.5 * usual, usual + " " + lastForce("hard"));
    assertEquals(null, report("usual").get("/segments/3/name"), "the tissue is no segment");
  }

  @ParameterizedTest
  @CsvSource({
    "fat=skin, a fill lies between two segments",
    "fat=skin..brain, there is no segment brain",
    "skull=skin..skull, a segment has the name of the fill",
    "fat=jaw..skull, there is no empty space between the segments",
  })
  void aWrongFillIsRefusedInOneLine(String fill, String line) {
    String refusal = head("", "--fill", fill).mustRefuse();
    assertTrue(refusal.startsWith("palpate: " + line + ": --fill " + fill + ": "), refusal);
  }

  @Test
  void aFillNeedsAnElasticSegment() {
    CommandRun run =
        replay("cheek.csv", "", "--phantom", "head:" + EDGE, "--fill", "fat=skin..skull");
    assertTrue(run.mustRefuse().startsWith("palpate: no segment is elastic: --fill: "), run.err());
  }

  /** Writes a scene of the block phantom, in which the block has the given further keys. */
  private Path scene(String name, String ofBlock, String further) throws IOException {
    CommandRun.of("info", "--phantom", "block:" + EDGE, "--export", file("block.nrrd"))
        .mustSucceed();
    String text =
        "{'bodies':[{'name':'block','volume':'block.nrrd','segment':'label:1'"
            + ofBlock
            + "},{'name':'base','volume':'block.nrrd','segment':'label:2'}]"
            + further
            + "}";
    return Files.writeString(file(name), text.replace('\'', '"'));
  }

  @Test
  void aSceneGivesTheSameFramesAsTheOptions() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000,'poisson':0.3", "");
    replay("top.csv", "scene", "--scene", scene, "--lattice", 8).mustSucceed();
    List<Object> options = new ArrayList<>(List.of("--phantom", "block:" + EDGE, "--lattice", 8));
    options.addAll(List.of("--elastic", "block=young:20e3,poisson:0.3"));
    replay("top.csv", "options", options.toArray()).mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("fscene")), Files.readAllBytes(file("foptions")));
    assertTrue(force("scene") > 0.1, report("scene").toString());
    assertEquals(report("options").get("/elastic/hexes"), report("scene").get("/elastic/hexes"));
  }

  @Test
  void aLiveSessionTouchesTheElasticBodiesOfAScene() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000", "");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--lattice", 8, "--seconds", 2, "--report", file("rlive")));
    CommandRun.of(touch.toArray()).mustSucceed();
    assertTrue(Integer.parseInt(report("live").get("/elastic/updates")) > 3);
  }

  @Test
  void whatASessionWritesIsTheSceneThatItTouched() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000,'poisson':0.3", "");
    Path left = file("left.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--lattice", 16, "--seconds", 0.3));
    touch.addAll(List.of("--save-scene", left, "--export", file("left.nrrd")));
    CommandRun.of(touch.toArray()).mustSucceed();
    replay("top.csv", "before", "--scene", scene, "--lattice", 8).mustSucceed();
    replay("top.csv", "after", "--scene", left, "--lattice", 8).mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("fbefore")), Files.readAllBytes(file("fafter")));
  }

  @Test
  void whatASessionWritesKeepsAllThatTheSceneStates() throws IOException {
    String further =
        ",'tool':{'spec':'point'},'device':{'scale':0.5,'offset_mm':[1,2,3]},"
            + "'protect':['base'],'carve':0.1";
    String elastic =
        ",'mobility':'elastic','young_pa':20000,'material':'stiffness:0.5,friction:0.2'";
    Path scene = scene("s.json", elastic, further);
    Path left = file("left.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--lattice", 16, "--seconds", 0.3));
    touch.addAll(List.of("--save-scene", left, "--export", file("left.nrrd")));
    CommandRun.of(touch.toArray()).mustSucceed();
    Map<String, String> before = FlatJson.read(scene);
    Map<String, String> after = FlatJson.read(left);
    before.keySet().removeIf(key -> key.endsWith("/volume"));
    before.forEach(
        (key, value) -> {
          boolean isNumber = value.matches("[0-9.]+");
          assertEquals(
              isNumber ? Double.parseDouble(value) : value,
              isNumber ? Double.parseDouble(after.get(key)) : after.get(key),
              key);
        });
  }

  @Test
  void aSceneThatASessionWroteHasItsFills() throws IOException {
    Path left = file("left.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "head:" + EDGE));
    touch.addAll(List.of("--elastic", "skin=young:20e3", "--elastic", "tissue=young:5e3"));
    touch.addAll(List.of("--headless", "--lattice", 8, "--seconds", 0.3));
    touch.addAll(List.of("--save-scene", left, "--export", file("left.nrrd")));
    CommandRun.of(touch.toArray()).mustSucceed();
    head("before", "--elastic", "tissue=young:5e3").mustSucceed();
    replay("cheek.csv", "after", "--scene", left, "--lattice", 4).mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("fbefore")), Files.readAllBytes(file("fafter")));
    String fill = "/elastic/untouchable_voxels";
    assertEquals(report("before").get(fill), report("after").get(fill));
    assertEquals(null, report("after").get("/segments/3/name"), "the tissue is no segment");
    replay("cheek.csv", "hard", "--scene", left, "--lattice", 4, "--elastic", "tissue=young:1e5")
        .mustSucceed();
    assertTrue(lastForce("hard") > 1.5 * lastForce("after"));
    String info = CommandRun.of("info", "--scene", left).mustSucceed().out();
    String voxels = report("after").get(fill);
    assertTrue(info.replace(",", "").contains("fill      tissue: " + voxels + " voxels"), info);
  }

  @Test
  void aFillWithoutVoxelsIsRefusedInOneLine() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000", "");
    String fill =
        ",{'name':'fat','volume':'block.nrrd','segment':'fill:label:7',"
            + "'mobility':'elastic','young_pa':1000}]";
    Files.writeString(scene, Files.readString(scene).replace("]", fill.replace('\'', '"')));
    String refusal = replay("top.csv", "", "--scene", scene).mustRefuse();
    assertTrue(refusal.startsWith("palpate: the fill fat has no voxel: "), refusal);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        ",'mobility':'elastic','young_pa':1||modulus must be 10 to 1e12 Pa",
        ",'mobility':'elastic','young_pa':1e4,'pose':{'translation_mm':[1,0,0]}"
            + "||bodies[0].pose moves a body",
        ",'mobility':'elastic','young_pa':1e4|,'tool':{'spec':'sphere:2'}|a rigid tool touches no",
        ",'mobility':'elastic','young_pa':1e4|,'tool':{'spec':'point','mass_kg':0.1}|a point with",
      })
  void whatDoesNotFitIsRefusedInOneLine(String ofBlock, String further, String line)
      throws IOException {
    Path scene = scene("wrong.json", ofBlock, further == null ? "" : further);
    String refusal = replay("top.csv", "", "--scene", scene).mustRefuse();
    assertTrue(refusal.startsWith("palpate: " + line), refusal);
  }

  @Test
  void aMovableBodyBesideAnElasticOneIsRefused() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000", "");
    String text =
        Files.readString(scene).replace("label:2\"", "label:2\",\"mobility\":\"movable\"");
    Files.writeString(scene, text);
    String refusal = replay("top.csv", "", "--scene", scene).mustRefuse();
    assertTrue(refusal.startsWith("palpate: bodies[1].mobility is movable"), refusal);
  }

  @Test
  void posesDoNotMoveElasticBodies() throws IOException {
    Path scene = scene("s.json", ",'mobility':'elastic','young_pa':20000", "");
    Path poses = Files.writeString(file("p.csv"), "frame,body,x,y,z,qw,qx,qy,qz\n");
    String refusal = replay("top.csv", "", "--scene", scene, "--poses", poses).mustRefuse();
    assertTrue(refusal.startsWith("palpate: elastic bodies and those beside them"), refusal);
  }
}
