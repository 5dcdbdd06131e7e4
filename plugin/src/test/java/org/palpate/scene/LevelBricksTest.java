package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceBuilder;
import org.palpate.scene.surface.SurfaceExtractor;
import org.palpate.scene.surface.SurfaceSource;
import org.palpate.volume.BitCube;

class LevelBricksTest {
  private final LevelBricks bricks = new LevelBricks();
  private final BitCube bits = new BitCube(4, 4, 4);
  private final SurfaceBuilder.Store store = bricks.storeOf(bits);

  private static SurfaceBrick mesh() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 1, 1);
    SurfaceSource source = SurfaceSource.ofBits(bits, new Vec3(1, 1, 1));
    return new SurfaceExtractor().extract(source, AmbientOcclusion.NONE, 0);
  }

  @Test
  void aMeshStartedBeforeAnEditDoesNotReplaceOneStartedAfterIt() {
    SurfaceBrick newer = mesh();
    store.accept(3, 8, newer);
    store.accept(3, 5, mesh());
    assertSame(newer, bricks.shown().get(3));
    store.accept(3, 7, null);
    assertSame(newer, bricks.shown().get(3));
  }

  @Test
  void anOlderMeshDoesNotReturnToAnEmptiedBrick() {
    store.accept(3, 8, null);
    store.accept(3, 5, mesh());
    assertTrue(bricks.shown().isEmpty());
    SurfaceBrick newest = mesh();
    store.accept(3, 9, newest);
    assertSame(newest, bricks.shown().get(3));
  }

  @Test
  void aMeshOfVoxelsThatWereReplacedIsIgnoredHoweverLateItStarts() {
    SurfaceBuilder.Store other = bricks.storeOf(new BitCube(4, 4, 4));
    SurfaceBrick mesh = mesh();
    other.accept(3, 5, mesh);
    store.accept(3, 6, mesh());
    store.accept(4, 7, mesh());
    assertEquals(Map.of(3, mesh), bricks.shown());
  }

  @Test
  void theNewestBrickIsThatOfTheSameVoxelsAlone() {
    assertEquals(Optional.empty(), store.newest(3));
    store.accept(3, 5, null);
    assertEquals(Optional.of(SurfaceBrick.EMPTY), store.newest(3));
    SurfaceBrick mesh = mesh();
    store.accept(3, 6, mesh);
    assertSame(mesh, store.newest(3).orElseThrow());
    SurfaceBuilder.Store other = bricks.storeOf(new BitCube(4, 4, 4));
    assertEquals(Optional.empty(), other.newest(3));
    assertSame(mesh, bricks.shown().get(3));
    other.accept(3, 7, mesh());
    assertEquals(Optional.empty(), store.newest(3));
  }
}
