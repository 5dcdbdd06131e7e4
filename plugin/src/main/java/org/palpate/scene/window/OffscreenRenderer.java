package org.palpate.scene.window;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneState;
import org.palpate.scene.gl.SceneRenderer;

/**
 * Draws a scene into memory; needs a display to reach the driver, but opens no window. One thread.
 */
public final class OffscreenRenderer implements AutoCloseable {
  private final int width;
  private final int height;
  private final int scale;
  private final GLOffscreenAutoDrawable drawable;
  private final SceneRenderer renderer = new SceneRenderer();

  /**
   * Opens a picture to draw into.
   *
   * @param scale each pixel is the mean of this many squared, 1 to 4
   * @throws GraphicsException where there is no display, no driver or no memory, with what to do
   */
  public OffscreenRenderer(int width, int height, int scale) throws GraphicsException {
    this.width = width;
    this.height = height;
    this.scale = scale;
    GLProfile profile = GraphicsDriver.profile();
    GLOffscreenAutoDrawable made = null;
    try {
      GLCapabilities capabilities = new GLCapabilities(profile);
      capabilities.setOnscreen(false);
      capabilities.setDoubleBuffered(false);
      capabilities.setFBO(true);
      made =
          GLDrawableFactory.getFactory(profile)
              .createOffscreenAutoDrawable(null, capabilities, null, width, height);
      made.setRealized(true);
      made.display();
      drawable = made;
      withContext(renderer::init);
    } catch (GLException | IllegalStateException e) {
      if (made != null) {
        made.destroy();
      }
      throw GraphicsDriver.refused(e);
    }
  }

  private interface Work {
    void run(GL3 gl);
  }

  private void withContext(Work work) {
    RuntimeException[] failure = new RuntimeException[1];
    drawable.invoke(
        true,
        current -> {
          try {
            work.run(current.getGL().getGL3());
          } catch (RuntimeException e) {
            failure[0] = e;
          }
          return true;
        });
    if (failure[0] != null) {
      throw failure[0];
    }
  }

  /** Draws a state and reads it back. */
  public Picture draw(SceneState state) {
    Picture[] picture = new Picture[1];
    withContext(
        gl -> {
          renderer.draw(gl, state, gl.getDefaultDrawFramebuffer(), width, height, scale);
          picture[0] = PixelReader.read(gl, width, height);
        });
    return picture[0];
  }

  /** Writes the place that a pixel of the last picture shows into {@code at}. */
  public boolean pick(SceneState state, double x, double y, Vec3 at) {
    boolean[] found = new boolean[1];
    withContext(gl -> found[0] = renderer.pick(gl, state, x, y, width, height, scale, at));
    return found[0];
  }

  /** What is left out; see {@link SceneRenderer#skip}. */
  public void skip(boolean unseen, boolean unchanged) {
    renderer.skip(unseen, unchanged);
  }

  /** How often what stands still was drawn anew. */
  public long stillDrawn() {
    return renderer.stillDrawn();
  }

  @Override
  public void close() {
    if (drawable.isRealized()) {
      withContext(renderer::dispose);
      drawable.destroy();
    }
  }
}
