package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceExtractor;
import org.palpate.scene.surface.SurfaceSource;
import org.palpate.volume.BitCube;

class LevelBricksTest {
  private final LevelBricks bricks = new LevelBricks();

  private static SurfaceBrick mesh() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 1, 1);
    SurfaceSource source = SurfaceSource.ofBits(bits, new Vec3(1, 1, 1));
    return new SurfaceExtractor().extract(source, AmbientOcclusion.NONE, 0);
  }

  @Test
  void aMeshStartedBeforeAnEditDoesNotReplaceOneStartedAfterIt() {
    SurfaceBrick newer = mesh();
    bricks.put(3, 8, newer);
    bricks.put(3, 5, mesh());
    assertSame(newer, bricks.shown().get(3));
    bricks.put(3, 7, null);
    assertSame(newer, bricks.shown().get(3));
  }

  @Test
  void anOlderMeshDoesNotReturnToAnEmptiedBrick() {
    bricks.put(3, 8, null);
    bricks.put(3, 5, mesh());
    assertTrue(bricks.shown().isEmpty());
    SurfaceBrick newest = mesh();
    bricks.put(3, 9, newest);
    assertSame(newest, bricks.shown().get(3));
  }
}
