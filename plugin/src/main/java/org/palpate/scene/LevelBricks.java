package org.palpate.scene;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.palpate.scene.surface.SurfaceBrick;

/** The bricks of one level of detail. Any thread puts and reads; a newer mesh is never lost. */
final class LevelBricks {
  private final Map<Integer, SurfaceBrick> shown = new ConcurrentHashMap<>();
  private final Map<Integer, Long> begun = new HashMap<>();

  /** Takes a mesh, null for none, unless one that was begun later is there. */
  synchronized void put(int brick, long begunAt, SurfaceBrick mesh) {
    Long before = begun.get(brick);
    if (before != null && before > begunAt) {
      return;
    }
    begun.put(brick, begunAt);
    if (mesh == null) {
      shown.remove(brick);
    } else {
      shown.put(brick, mesh);
    }
  }

  /** By the bricks' numbers; may change while read. */
  Map<Integer, SurfaceBrick> shown() {
    return shown;
  }
}
