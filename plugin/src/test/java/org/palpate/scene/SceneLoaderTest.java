package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class SceneLoaderTest {
  private static final long PATIENCE_MS = 60_000;
  private static final int EDGE = 24;

  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);

  @Test
  void finerLevelsWaitUntilTheCoarsestWasDrawn() throws Exception {
    try (SceneLoader loader =
        SceneLoader.forWindow(model, volume(box(), dot()), List.of(), List.of(), 1)) {
      loader.await(PATIENCE_MS);
      assertEquals(List.of(2, 2), finest());
      assertEquals(1.0 / SceneObject.LEVELS, loader.progress());
      loader.pictureDrawn();
      loader.await(PATIENCE_MS);
      assertEquals(1, loader.progress());
      assertEquals(List.of(0, 0), finest());
      assertTrue(model.objects().get(0).isComplete(1), "the level between is made too");
    }
  }

  @Test
  void anEmptySegmentDoesNotDelayFinerLevels() throws Exception {
    BitCube empty = new BitCube(EDGE, EDGE, EDGE);
    try (SceneLoader loader =
        SceneLoader.forWindow(model, volume(empty, box()), List.of(), List.of(), 1)) {
      loader.await(PATIENCE_MS);
      loader.pictureDrawn();
      loader.await(PATIENCE_MS);
      assertEquals(List.of(0, 0), finest());
    }
  }

  @Test
  void anEditBeforeThePictureAppearsInTheFinerLevels() throws Exception {
    BitCube bits = box();
    try (SceneLoader loader = SceneLoader.forWindow(model, volume(bits), List.of(), List.of(), 1)) {
      loader.await(PATIENCE_MS);
      IntBox edited = new IntBox();
      for (int i = 14; i < 20; i++) {
        bits.set(i, 10, 10);
        edited.include(i, 10, 10);
      }
      for (SurfaceJob level : loader.remesh(0, edited)) {
        level.await(PATIENCE_MS);
      }
      loader.pictureDrawn();
      loader.await(PATIENCE_MS);
    }
    SceneModel anew = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(anew, volume(bits), 1)) {
      loader.await(PATIENCE_MS);
    }
    for (int level = 0; level < SceneObject.LEVELS; level++) {
      assertEquals(
          anew.objects().get(0).triangleCount(level),
          model.objects().get(0).triangleCount(level),
          "level " + level);
    }
  }

  @Test
  void aPictureAfterClosingStartsNothing() throws Exception {
    SceneLoader loader = SceneLoader.forWindow(model, volume(box()), List.of(), List.of(), 1);
    loader.await(PATIENCE_MS);
    loader.close();
    loader.pictureDrawn();
    assertFalse(model.objects().get(0).isComplete(0));
  }

  private List<Integer> finest() {
    return model.objects().stream().map(SceneObject::finestComplete).toList();
  }

  private static SegmentedVolume volume(BitCube... segments) {
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, 1), RigidTransform.identity());
    return new SegmentedVolume(
        grid, List.of(segments).stream().map(bits -> new Segment("one", bits, 0xd62728)).toList());
  }

  private static BitCube box() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 6; k < 14; k++) {
      for (int j = 6; j < 14; j++) {
        for (int i = 6; i < 14; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private static BitCube dot() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    bits.set(20, 20, 20);
    return bits;
  }
}
