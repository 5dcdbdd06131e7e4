package org.palpate.io.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;

class OpenedSceneTest {
  private final Path folder = Path.of("scenes").toAbsolutePath();
  private final SceneBody skin =
      SceneBody.ofVolume("skin", "scans/head.nrrd", "label:1", Mobility.FIXED, new Pose())
          .elastic(20e3, 0.3);
  private final SceneFile scene =
      new SceneFile(
          List.of(skin),
          List.of(new SceneFill("fat", "scans/head.nrrd", "label:4", 1e3, OptionalDouble.empty())),
          Optional.of(
              new SceneTool("point", Optional.empty(), Optional.empty(), OptionalDouble.empty())),
          Optional.empty(),
          List.of("skin"),
          OptionalDouble.of(20));
  private final OpenedScene opened = new OpenedScene(scene, folder.resolve("head.json"));

  @Test
  void allNamesOfFilesAreRelativeToTheNewFile() {
    SceneFile at = opened.at(List.of(new Pose()), folder.resolve("results/end.json"));
    assertEquals("../scans/head.nrrd", at.bodies().get(0).source());
    assertEquals("../scans/head.nrrd", at.fills().get(0).source());
    SceneFile same = opened.at(List.of(new Pose()), folder.resolve("end.json"));
    assertEquals(scene.fills(), same.fills());
  }

  @Test
  void fillsStayInTheirVolumesWhenBodiesBecomeLabelsOfAnother() {
    SceneFile labels =
        opened.asLabels(List.of(new Pose()), "end.nrrd", folder.resolve("results/end.json"));
    assertEquals("end.nrrd", labels.bodies().get(0).source());
    assertEquals("../scans/head.nrrd", labels.fills().get(0).source());
    assertEquals("label:4", labels.fills().get(0).segment());
  }

  @Test
  void everythingElseStaysAsItWasRead() {
    SceneFile labels = opened.asLabels(List.of(new Pose()), "end.nrrd", folder.resolve("end.json"));
    assertEquals(
        skin.asLabel("end.nrrd", 1).at("end.nrrd", labels.bodies().get(0).pose()),
        labels.bodies().get(0));
    assertEquals(scene.tool(), labels.tool());
    assertEquals(scene.protect(), labels.protect());
    assertEquals(scene.carve(), labels.carve());
  }
}
