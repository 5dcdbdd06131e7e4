package org.palpate.scene.surface;

/**
 * Ambient occlusion of a surface: how much of the sky a point sees. Several threads read it at
 * once.
 */
@FunctionalInterface
public interface AmbientOcclusion {
  /** No occlusion anywhere: every point has the value 1. */
  AmbientOcclusion NONE = (x, y, z, nx, ny, nz) -> 1;

  /**
   * Returns the ambient light that reaches a point: 1 if nothing occludes it, near 0 deep in a
   * hole.
   *
   * <p>This is the convention of glTF's occlusion texture.
   *
   * @param x grid coordinates of the point
   * @param nx unit normal of the surface there, along the grid's axes
   */
  float at(float x, float y, float z, float nx, float ny, float nz);
}
