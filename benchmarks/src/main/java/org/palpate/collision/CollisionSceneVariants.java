package org.palpate.collision;

import java.util.List;
import org.palpate.volume.BitCube;

/** Opens the package-private factories of {@link CollisionScene} to the benchmarks. */
public final class CollisionSceneVariants {
  private CollisionSceneVariants() {}

  /** Returns a scene with a broad phase, whatever the number of cubes. */
  public static CollisionScene withBroadPhase(List<BitCube> cubes) {
    return CollisionScene.withBroadPhase(cubes);
  }

  /** Returns a scene whose queries look at every cube. */
  public static CollisionScene withoutBroadPhase(List<BitCube> cubes) {
    return CollisionScene.withoutBroadPhase(cubes);
  }
}
