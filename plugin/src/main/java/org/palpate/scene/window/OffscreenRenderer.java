package org.palpate.scene.window;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.palpate.scene.SceneState;
import org.palpate.scene.gl.PickedPoint;
import org.palpate.scene.gl.SceneRenderer;

/**
 * Draws a scene into memory. It needs a display to reach the driver, but opens no window. One
 * thread.
 */
public final class OffscreenRenderer implements AutoCloseable {
  private final int width;
  private final int height;
  private final int scale;
  private final GLOffscreenAutoDrawable drawable;
  private final SceneRenderer renderer;

  /**
   * Creates a picture to draw into.
   *
   * @param width width in pixels
   * @param height height in pixels
   * @param scale edge of the square of samples that each pixel averages, 1 to 4
   * @throws GraphicsException if there is no display, no driver or no memory, with the remedy
   */
  public OffscreenRenderer(int width, int height, int scale) throws GraphicsException {
    this(width, height, scale, new SceneRenderer());
  }

  OffscreenRenderer(int width, int height, int scale, SceneRenderer renderer)
      throws GraphicsException {
    this.renderer = renderer;
    this.width = width;
    this.height = height;
    this.scale = scale;
    GLProfile profile = GraphicsDriver.profile();
    GLOffscreenAutoDrawable created = null;
    try {
      GLCapabilities capabilities = new GLCapabilities(profile);
      capabilities.setOnscreen(false);
      capabilities.setDoubleBuffered(false);
      capabilities.setFBO(true);
      created =
          GLDrawableFactory.getFactory(profile)
              .createOffscreenAutoDrawable(null, capabilities, null, width, height);
      created.setRealized(true);
      created.display();
      drawable = created;
      withContext(renderer::init);
    } catch (GLException | IllegalStateException e) {
      if (created != null) {
        created.destroy();
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

  /** Draws a state and returns the picture. */
  public Picture draw(SceneState state) {
    Picture[] picture = new Picture[1];
    withContext(
        gl -> {
          renderer.draw(gl, state, gl.getDefaultDrawFramebuffer(), width, height, scale);
          picture[0] = PixelReader.read(gl, width, height);
        });
    return picture[0];
  }

  /** Returns the point that a pixel of the last picture shows; empty if there is no surface. */
  Optional<PickedPoint> pick(SceneState state, double x, double y) {
    AtomicReference<Optional<PickedPoint>> found = new AtomicReference<>(Optional.empty());
    withContext(gl -> found.set(renderer.pick(gl, state, x, y, width, height, scale)));
    return found.get();
  }

  /** Returns how often the picture of the static parts was reused. */
  long staticReused() {
    return renderer.staticReused();
  }

  @Override
  public void close() {
    if (drawable.isRealized()) {
      withContext(renderer::dispose);
      drawable.destroy();
    }
  }
}
