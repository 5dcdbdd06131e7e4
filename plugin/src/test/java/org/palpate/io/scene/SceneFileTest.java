package org.palpate.io.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.VolumeFormatException;

class SceneFileTest {
  @TempDir private Path folder;

  @Test
  void readsTheExampleOfTheContract() throws IOException {
    SceneFile scene =
        read(
            "{ \"bodies\": [ { \"name\": \"skull\", \"volume\": \"ct.nrrd\", \"segment\":"
                + " \">=1500\", \"mobility\": \"fixed\" },\n"
                + "{ \"name\": \"fragment\", \"volume\": \"seg.nrrd\", \"segment\": \"label:3\","
                + " \"mobility\": \"movable\",\n"
                + "\"pose\": { \"translation_mm\": [1, 2, 3], \"rotation\": [1, 0, 0, 0] },"
                + " \"material\": \"stiffness:0.8,friction:0.2\" } ],\n"
                + "\"tool\": { \"spec\": \"point\" } }");
    SceneBody fragment = scene.bodies().get(1);
    assertEquals("fragment", fragment.name());
    assertEquals("seg.nrrd", fragment.source());
    assertEquals(Mobility.MOVABLE, fragment.mobility());
    assertTrue(fragment.pose().translation.sameBits(new Vec3(1, 2, 3)));
    assertEquals("point", scene.tool().orElseThrow().spec());
    assertEquals(Mobility.FIXED, scene.bodies().get(0).mobility());
  }

  @Test
  void keepsEveryBitOfARandomScene() throws IOException {
    SplittableRandom random = new SplittableRandom(7);
    for (int round = 0; round < 50; round++) {
      SceneFile scene = randomScene(random);
      byte[] once = bytes(scene);
      Path file = Files.write(folder.resolve("s.json"), once);
      SceneFile again = SceneReader.read(file);
      assertArrayEquals(once, bytes(again));
      for (int n = 0; n < scene.bodies().size(); n++) {
        assertTrue(scene.bodies().get(n).pose().sameBits(again.bodies().get(n).pose()));
      }
      assertEquals(scene.fills(), again.fills());
      assertEquals(scene.carve(), again.carve());
      assertEquals(scene.tool(), again.tool());
      assertEquals(scene.protect(), again.protect());
      assertTrue(
          scene.device().get().offsetMm().get().sameBits(again.device().get().offsetMm().get()));
    }
  }

  private static SceneFile randomScene(SplittableRandom random) {
    List<SceneBody> bodies = new ArrayList<>();
    for (int n = 0; n < 4; n++) {
      Pose pose = new Pose();
      pose.rotation.set(random.nextDouble(), random.nextDouble(), -random.nextDouble(), 0.1);
      pose.rotation.normalize();
      pose.translation.set(1e3 * random.nextDouble(), -0.0, Double.MIN_VALUE);
      bodies.add(SceneBody.ofVolume("b" + n, "v.nrrd", "label:" + n, Mobility.MOVABLE, pose));
    }
    bodies.add(
        new SceneBody(
            "soft",
            "m.stl",
            true,
            Optional.empty(),
            Mobility.ELASTIC,
            new Pose(),
            Optional.of("friction:0.3"),
            OptionalDouble.of(random.nextDouble(1e5)),
            OptionalDouble.of(0.49 * random.nextDouble())));
    List<SceneFill> fills =
        List.of(
            new SceneFill("fat", "v.nrrd", ">=3", random.nextDouble(1e5), OptionalDouble.empty()),
            SceneFill.ofLabel("muscle", "v.nrrd", 7, 1e4, 0.49 * random.nextDouble()));
    return new SceneFile(
        bodies,
        fills,
        Optional.of(
            new SceneTool(
                "tool.nrrd",
                Optional.of("t=nonzero"),
                Optional.of("-0.5"),
                OptionalDouble.of(random.nextDouble(0.1, 1)))),
        Optional.of(
            new SceneDevice(
                OptionalDouble.of(random.nextDouble(0.1, 3)),
                Optional.of("view"),
                Optional.of(new Vec3(random.nextDouble(), -1e-300, 1e300)))),
        List.of("nerve:0.5", "skull"),
        OptionalDouble.of(random.nextDouble(1, 9)));
  }

  /**
   * The first column is the part of the message that names the key; {@code '} stands for quotes.
   */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "there is no key colour|{'bodies':[B],'colour':1}",
        "there is no key bodies[0].color|{'bodies':[{'name':'a','volume':'v','color':1}]}",
        "there is no key"
            + " bodies[0].pose.origin|{'bodies':[{'name':'a','volume':'v','pose':{'origin':1}}]}",
        "there is no key tool.size|{'bodies':[B],'tool':{'spec':'point','size':1}}",
        "there is no key device.x|{'bodies':[B],'device':{'x':1}}",
        "device.axes must be patient or view|{'bodies':[B],'device':{'axes':'up'}}",
        "bodies must have|{'bodies':[]}",
        "bodies must have|{}",
        "bodies must be an array|{'bodies':{}}",
        "bodies[0].name is missing|{'bodies':[{'volume':'v'}]}",
        "bodies[0].name must be a text|{'bodies':[{'name':7,'volume':'v'}]}",
        "bodies[0] must have either|{'bodies':[{'name':'a'}]}",
        "bodies[0] must have either|{'bodies':[{'name':'a','volume':'v','mesh':'m.stl'}]}",
        "bodies[0].segment is for a volume|{'bodies':[{'name':'a','mesh':'m.stl','segment':'x'}]}",
        "bodies[1].name is a|{'bodies':[B,B]}",
        "bodies[0].mobility must be|{'bodies':[{'name':'a','volume':'v','mobility':'free'}]}",
        "bodies[1] is a fill, so|{'bodies':[B,{'name':'b','volume':'v','segment':'fill:label:2'}]}",
        "bodies[1] is a fill, so|{'bodies':[B,{'name':'b','volume':'v','segment':'fill:label:2',"
            + "'mobility':'elastic','young_pa':1,'material':'friction:0.2'}]}",
        "bodies[1] is a fill, and no body before|{'bodies':[B,{'name':'b','volume':'v',"
            + "'segment':'fill:label:2','mobility':'elastic','young_pa':1}]}",
        "bodies[1].volume must be|{'bodies':[{'name':'a','volume':'v','mobility':'elastic',"
            + "'young_pa':1},{'name':'b','volume':'w','segment':'fill:label:2',"
            + "'mobility':'elastic','young_pa':1}]}",
        "bodies[2] comes after a fill|{'bodies':[{'name':'a','volume':'v','mobility':'elastic',"
            + "'young_pa':1},{'name':'b','volume':'v','segment':'fill:label:2',"
            + "'mobility':'elastic','young_pa':1},{'name':'c','volume':'v'}]}",
        "bodies[0].young_pa is missing|{'bodies':[{'name':'a','volume':'v','mobility':'elastic'}]}",
        "bodies[0].young_pa is for|{'bodies':[{'name':'a','volume':'v','young_pa':1}]}",
        "bodies[0].young_pa must"
            + " be|{'bodies':[{'name':'a','volume':'v','mobility':'elastic','young_pa':0}]}",
        "bodies[0].poisson must"
            + " be|{'bodies':[{'name':'a','volume':'v','mobility':'elastic','young_pa':1,'poisson':0.5}]}",
        "bodies[0].pose.rotation must"
            + " be|{'bodies':[{'name':'a','volume':'v','pose':{'rotation':[1,0,0]}}]}",
        "bodies[0].pose.translation_mm must be"
            + " from|{'bodies':[{'name':'a','volume':'v','pose':{'translation_mm':[0,-1048577,0]}}]}",
        "bodies[0].pose.rotation has the"
            + " norm|{'bodies':[{'name':'a','volume':'v','pose':{'rotation':[1,1,0,0]}}]}",
        "bodies[0].pose.translation_mm must"
            + " be|{'bodies':[{'name':'a','volume':'v','pose':{'translation_mm':[1,2,1e999]}}]}",
        "bodies[0].pose must be an object|{'bodies':[{'name':'a','volume':'v','pose':[1]}]}",
        "tool.spec is missing|{'bodies':[B],'tool':{}}",
        "tool.mass_kg must be|{'bodies':[B],'tool':{'spec':'point','mass_kg':-1}}",
        "device.scale must be|{'bodies':[B],'device':{'scale':'2'}}",
        "device.offset_mm must be|{'bodies':[B],'device':{'offset_mm':[1]}}",
        "protect[0] must be|{'bodies':[B],'protect':[1]}",
        "carve must be|{'bodies':[B],'carve':0}",
        "version must be 1|{'version':2,'bodies':[B]}",
        "the scene must be an object|[1]",
        "no JSON|{'bodies':[B}",
        "no JSON, it ends too early|{'bodies':[B",
        "must be a number above 0:|{'bodies':[B],'carve':-1}",
        "no JSON|{'carve':1,'carve':2}",
        "something follows|{'bodies':[B]} {}",
        "no JSON|{'carve':NaN}"
      })
  void refusesInOneLineThatNamesTheKey(String names, String json) {
    String body = "{'name':'a','volume':'v.nrrd'}";
    String text = json.replace("[B", "[" + body).replace(",B", "," + body).replace('\'', '"');
    String message = assertThrows(VolumeFormatException.class, () -> read(text)).getMessage();
    assertTrue(message.contains(names), message);
    assertTrue(message.contains("s.json: ") && !message.contains("\n"), message);
  }

  @Test
  void saysThatAFileIsNestedTooDeeply() {
    String message =
        assertThrows(VolumeFormatException.class, () -> read("[".repeat(5000))).getMessage();
    assertTrue(message.contains("nested too deeply"), message);
  }

  @Test
  void aQuaternionThatIsNearlyUnitIsNormalized() throws IOException {
    Pose pose =
        read("{\"bodies\":[{\"name\":\"a\",\"volume\":\"v\",\"pose\":{\"rotation\":"
                + "[0.7071,0.7071,0,0]}}]}")
            .bodies()
            .get(0)
            .pose();
    assertTrue(pose.rotation.isUnit());
  }

  private SceneFile read(String json) throws IOException {
    return SceneReader.read(Files.writeString(folder.resolve("s.json"), json));
  }

  private static byte[] bytes(SceneFile scene) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    SceneWriter.write(scene, bytes);
    return bytes.toByteArray();
  }
}
