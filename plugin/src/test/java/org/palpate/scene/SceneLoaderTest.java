package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class SceneLoaderTest {
  private static final long PATIENCE_MS = 60_000;
  private static final int EDGE = 24;

  /** Several bricks at the finest level. */
  private static final int EDITED_EDGE = 90;

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

  /** Compares with surfaces that are built after all edits, bit for bit. */
  @Test
  void editsWhileSurfacesAreBuiltEndInThoseOfTheEditedVoxels() throws Exception {
    long seed = Seeds.seed();
    Random random = new Random(seed);
    BitCube bits = new BitCube(EDITED_EDGE, EDITED_EDGE, EDITED_EDGE);
    edit(bits, random, 40, true);
    try (SceneLoader loader = new SceneLoader(model, editedVolume(bits), 3)) {
      for (int n = 0; n < 40; n++) {
        List<SurfaceJob> levels = loader.remesh(0, edit(bits, random, 9, random.nextBoolean()));
        if (n % 4 == 3) {
          levels.get(0).await(PATIENCE_MS);
        }
        if (n % 10 == 9) {
          for (SurfaceJob level : levels) {
            level.await(PATIENCE_MS);
          }
        }
      }
      loader.await(PATIENCE_MS);
    }
    SceneModel anew = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(anew, editedVolume(bits), 2)) {
      loader.await(PATIENCE_MS);
    }
    for (int level = 0; level < SceneObject.LEVELS; level++) {
      Map<Integer, SurfaceBrick> expected = anew.objects().get(0).bricks(level);
      Map<Integer, SurfaceBrick> actual = model.objects().get(0).bricks(level);
      String said = "level " + level + " (-Dpalpate.seed=" + seed + ")";
      assertEquals(expected.keySet(), actual.keySet(), said);
      for (Map.Entry<Integer, SurfaceBrick> brick : expected.entrySet()) {
        SurfaceBrick patched = actual.get(brick.getKey());
        assertArrayEquals(brick.getValue().positionsMm(), patched.positionsMm(), said);
        assertArrayEquals(brick.getValue().triangles(), patched.triangles(), said);
      }
    }
  }

  private static SegmentedVolume editedVolume(BitCube bits) {
    VoxelGrid grid =
        new VoxelGrid(
            EDITED_EDGE, EDITED_EDGE, EDITED_EDGE, new Vec3(1, 1, 2), RigidTransform.identity());
    return new SegmentedVolume(grid, List.of(new Segment("one", bits, 0xd62728)));
  }

  /** Fills or empties a random box with random voxels, and returns it. */
  private static IntBox edit(BitCube bits, Random random, int edge, boolean solid) {
    int[] low = random.ints(3, 0, EDITED_EDGE - edge).toArray();
    IntBox box = new IntBox();
    for (int n = 0; n < edge * edge * edge; n++) {
      int i = low[0] + n % edge;
      int j = low[1] + n / edge % edge;
      int k = low[2] + n / edge / edge;
      box.include(i, j, k);
      if (solid && random.nextInt(10) > 0) {
        bits.set(i, j, k);
      } else if (!solid) {
        bits.clear(i, j, k);
      }
    }
    return box;
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
