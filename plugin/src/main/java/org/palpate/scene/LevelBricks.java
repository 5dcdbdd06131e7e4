package org.palpate.scene;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.palpate.scene.surface.SurfaceBrick;

/**
 * The surface bricks of one level of detail. Any thread puts and reads; an older mesh never
 * replaces a newer one.
 */
final class LevelBricks {
  private final Map<Integer, SurfaceBrick> shown = new ConcurrentHashMap<>();
  private final Map<Integer, Long> started = new HashMap<>();

  /**
   * Stores the mesh of a brick, or removes it if {@code mesh} is null, unless a later one is
   * stored.
   */
  synchronized void put(int brick, long startedAt, SurfaceBrick mesh) {
    Long before = started.get(brick);
    if (before != null && before > startedAt) {
      return;
    }
    started.put(brick, startedAt);
    if (mesh == null) {
      shown.remove(brick);
    } else {
      shown.put(brick, mesh);
    }
  }

  /** Returns the bricks by their numbers. The map may change while it is read. */
  Map<Integer, SurfaceBrick> shown() {
    return shown;
  }
}
