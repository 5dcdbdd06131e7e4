package org.palpate.scene.surface;

/** How open to light a place of a surface is. Read by several threads at once. */
@FunctionalInterface
public interface AmbientOcclusion {
  /** Wholly open everywhere: no shading of hollows. */
  AmbientOcclusion EVERYWHERE = (x, y, z, nx, ny, nz) -> 1;

  /**
   * 0 for a place in the depth of a hole, 1 for one that sees half the sky.
   *
   * @param x grid coordinates of the place
   * @param nx unit normal there, along the grid's axes
   */
  float at(float x, float y, float z, float nx, float ny, float nz);
}
