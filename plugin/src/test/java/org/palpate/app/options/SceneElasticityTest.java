package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.body.Mobility;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.geometry.Pose;
import org.palpate.io.scene.SceneBody;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneFill;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A liver that is elastic, a bone that is not, and a fill between them. */
class SceneElasticityTest {
  private static final int EDGE = 9;

  private final BitCube fill = voxels(5);
  private final SceneElasticity elasticity =
      new SceneElasticity(
          Map.of("liver", new ElasticMaterial(5000, 0.4), "tissue", new ElasticMaterial(2000, 0.3)),
          Map.of("tissue", fill));

  /** Returns the voxels of the layers from 0 to below a height. */
  private static BitCube voxels(int height) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * height; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    return bits;
  }

  private static SegmentedVolume bodies() {
    return new SegmentedVolume(
        VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE),
        List.of(new Segment("liver", voxels(2), 1), new Segment("bone", voxels(1), 2)));
  }

  @Test
  void aFillStandsBehindTheBodiesWithoutWhatTheyHold() {
    List<Segment> all = elasticity.leftBy(bodies()).withFills(bodies()).segments();
    assertEquals(List.of("liver", "bone", "tissue"), all.stream().map(Segment::name).toList());
    BitCube left = all.get(2).bits();
    assertEquals(3L * EDGE * EDGE, left.solidCount());
    assertFalse(left.get(8, 8, 1));
    assertTrue(left.get(8, 8, 2) && left.get(0, 0, 4));
    assertEquals(5L * EDGE * EDGE, fill.solidCount(), "the fill itself is not changed");
  }

  @Test
  void bodiesWithoutFillsStayTheSame() {
    SegmentedVolume bodies = bodies();
    assertSame(bodies, SceneElasticity.NONE.withFills(bodies));
  }

  @Test
  void aSceneGetsTheElasticityOfItsBodiesAndItsFillsAsLabels() {
    SceneFile rigid = SceneFile.ofBodies(List.of(body("liver", 1), body("bone", 2)));
    SceneFile scene = elasticity.of(rigid, "scene.nrrd");
    assertEquals(List.of(body("liver", 1).elastic(5000, 0.4), body("bone", 2)), scene.bodies());
    assertEquals(
        List.of(new SceneFill("tissue", "scene.nrrd", "label:3", 2000, OptionalDouble.of(0.3))),
        scene.fills());
  }

  /** A scene file refuses a fill without a voxel, so none may be written. */
  @Test
  void aFillThatEditsHaveCoveredIsLeftOut() {
    SegmentedVolume grown =
        new SegmentedVolume(
            VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE),
            List.of(new Segment("liver", voxels(6), 1), new Segment("bone", voxels(1), 2)));
    SceneElasticity left = elasticity.leftBy(grown);
    assertSame(grown, left.withFills(grown));
    SceneFile rigid = SceneFile.ofBodies(List.of(body("liver", 1), body("bone", 2)));
    assertEquals(List.of(), left.of(rigid, "scene.nrrd").fills());
    assertEquals(2, elasticity.leftBy(bodies()).of(rigid, "scene.nrrd").bodies().size());
  }

  @Test
  void whatIsUnchangedStaysAsTheFileStatesIt() {
    SceneBody usual = body("liver", 1).elastic(5000, 0.4);
    SceneBody stated =
        new SceneBody(
            usual.name(),
            usual.source(),
            false,
            usual.segment(),
            Mobility.ELASTIC,
            pose,
            Optional.of("friction:0.2"),
            usual.youngPa(),
            OptionalDouble.empty());
    SceneFill fat = new SceneFill("fat", "scene.nrrd", "label:2", 1000, OptionalDouble.empty());
    SceneFile scene = SceneFile.ofBodies(List.of(stated)).with(List.of(stated), List.of(fat));
    assertEquals(List.of(stated), elasticity.of(scene, "scene.nrrd").bodies());
    assertSame(scene, SceneElasticity.NONE.of(scene, "scene.nrrd"));
  }

  private final Pose pose = new Pose();

  private SceneBody body(String name, int label) {
    return SceneBody.ofVolume(name, "scene.nrrd", "label:" + label, Mobility.FIXED, pose);
  }
}
