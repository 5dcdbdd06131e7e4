package org.palpate.scene;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceBuilder;
import org.palpate.volume.BitCube;

/**
 * The surface bricks of one level of detail. Any thread puts and reads; an older mesh never
 * replaces a newer one.
 */
final class LevelBricks {
  private final Map<Integer, SurfaceBrick> shown = new ConcurrentHashMap<>();
  private final Map<Integer, Start> starts = new HashMap<>();

  /** The voxels whose surface is shown. Bricks of voxels that they replaced are ignored. */
  private BitCube current;

  /**
   * The start of the extraction that gave the newest mesh of a brick.
   *
   * @param order its order among all starts
   * @param bits the voxels from which it was made
   */
  private record Start(long order, BitCube bits) {}

  /**
   * Returns the place where the bricks of a cube are kept. From now on bricks of other cubes are
   * ignored: an extraction that waited while its voxels were replaced may end last.
   */
  synchronized SurfaceBuilder.Store storeOf(BitCube bits) {
    current = bits;
    return new SurfaceBuilder.Store() {
      @Override
      public void accept(int brick, long started, SurfaceBrick mesh) {
        put(brick, new Start(started, bits), mesh);
      }

      @Override
      public Optional<SurfaceBrick> newest(int brick) {
        return newestOf(brick, bits);
      }
    };
  }

  /**
   * Stores the mesh of a brick, or removes it if {@code mesh} is null, unless a later one is stored
   * or its voxels were replaced.
   */
  private synchronized void put(int brick, Start start, SurfaceBrick mesh) {
    Start before = starts.get(brick);
    if (start.bits != current || (before != null && before.order > start.order)) {
      return;
    }
    starts.put(brick, start);
    if (mesh == null) {
      shown.remove(brick);
    } else {
      shown.put(brick, mesh);
    }
  }

  private synchronized Optional<SurfaceBrick> newestOf(int brick, BitCube bits) {
    Start start = starts.get(brick);
    return start == null || start.bits != bits
        ? Optional.empty()
        : Optional.of(shown.getOrDefault(brick, SurfaceBrick.EMPTY));
  }

  /** Returns the bricks by their numbers. The map may change while it is read. */
  Map<Integer, SurfaceBrick> shown() {
    return shown;
  }
}
