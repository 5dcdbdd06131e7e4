package org.palpate.scene.window;

import org.palpate.scene.gl.SceneRenderer;

/**
 * Creates offscreen renderers with a given scene renderer, which benchmarks compare. It stands in
 * the renderer's package because production code has no such choice.
 */
public final class OffscreenRendererVariants {
  private OffscreenRendererVariants() {}

  /**
   * Returns an offscreen renderer with one sample a pixel.
   *
   * @throws GraphicsException if there is no display, no driver or no memory
   */
  public static OffscreenRenderer of(int width, int height, SceneRenderer renderer)
      throws GraphicsException {
    return new OffscreenRenderer(width, height, 1, renderer);
  }
}
