package org.palpate.scene.gl;

/**
 * Creates renderers without one of their skips, which benchmarks compare. It stands in the
 * renderer's package because production code has no such choice.
 */
public final class SceneRendererVariants {
  private SceneRendererVariants() {}

  /**
   * Returns a renderer.
   *
   * @param cullsOutsideView whether bricks outside the view are not drawn
   * @param reusesStatic whether the picture of the static parts is reused
   */
  public static SceneRenderer of(boolean cullsOutsideView, boolean reusesStatic) {
    return new SceneRenderer(cullsOutsideView, reusesStatic);
  }
}
