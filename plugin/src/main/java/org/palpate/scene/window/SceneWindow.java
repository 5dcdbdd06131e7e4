package org.palpate.scene.window;

import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.newt.event.WindowAdapter;
import com.jogamp.newt.event.WindowEvent;
import com.jogamp.newt.event.WindowUpdateEvent;
import com.jogamp.newt.opengl.GLWindow;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLCapabilitiesImmutable;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLEventListener;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneState;
import org.palpate.scene.gl.SceneRenderer;

/**
 * A window on a scene: it draws when the scene asks for it, on a thread of its own, and turns mouse
 * and keys into moves of the camera, of the hand, and into what the keys were given to do.
 *
 * <p>Opened and closed by any thread. Whatever befalls it (closed, context lost, driver failing) it
 * tells its owner once and disturbs no one else.
 */
public final class SceneWindow implements AutoCloseable {
  /** Why a window is no more. */
  public enum End {
    CLOSED_BY_USER,
    FAILED
  }

  /** The longest that a window is waited for which does not close, as where its display is gone. */
  private static final long CLOSE_MILLIS = 10_000;

  private final SceneModel model;
  private final Optional<ScenePanel> panel;
  private final GLWindow window;
  private final SceneRenderer renderer = new SceneRenderer();
  private final DrawThread drawing;
  private final WindowInput input;
  private final Consumer<End> onEnd;
  private final AtomicReference<Consumer<Picture>> snapshot = new AtomicReference<>();
  private volatile Throwable failure;
  private volatile boolean initialized;
  private volatile Runnable onPicture = () -> {};
  private volatile long drawnTriangles;
  private volatile long allTriangles;
  private volatile long firstSurfaceMillis;
  private volatile boolean ended;
  private volatile boolean displayLost;

  /**
   * A window that is not yet shown.
   *
   * @param onEnd told once when the window is gone and was not closed by {@link #close}
   * @throws GraphicsException where there is no display or no driver, with what to do
   */
  public SceneWindow(SceneModel model, String title, int width, int height, Consumer<End> onEnd)
      throws GraphicsException {
    this(model, Optional.empty(), onEnd);
    window.setTitle(title);
    window.setSize(width, height);
  }

  /** The same inside another program's window. */
  public SceneWindow(SceneModel model, ScenePanel panel, Consumer<End> onEnd)
      throws GraphicsException {
    this(model, Optional.of(panel), onEnd);
  }

  private SceneWindow(SceneModel model, Optional<ScenePanel> panel, Consumer<End> onEnd)
      throws GraphicsException {
    this.model = model;
    this.panel = panel;
    this.onEnd = onEnd;
    GLProfile profile = GraphicsDriver.profile();
    drawing = new DrawThread(this::draw, this::fail);
    try {
      window = GLWindow.create(capabilities(profile));
      input = new WindowInput(model, window::getSurfaceWidth, window::getSurfaceHeight);
      window.addGLEventListener(new AnatomyVoxelizer());
      window.addWindowListener(new Ending());
      window.addMouseListener(input);
      window.addKeyListener(input.keys());
    } catch (GLException | NativeWindowException e) {
      throw GraphicsDriver.refused(e);
    }
  }

  /**
   * Shows the window and begins to draw; once, when the input is set up.
   *
   * @throws GraphicsException where the driver refuses
   */
  public void show() throws GraphicsException {
    try {
      panel.ifPresentOrElse(place -> place.put(window), () -> window.setVisible(true));
    } catch (GLException | NativeWindowException e) {
      throw GraphicsDriver.refused(e);
    }
    model.onChange(drawing::request);
    drawing.start();
    drawing.request();
  }

  private static GLCapabilities capabilities(GLProfile profile) {
    GLCapabilities capabilities = new GLCapabilities(profile);
    capabilities.setDepthBits(24);
    capabilities.setStereo(hasStereo(profile));
    return capabilities;
  }

  /** Whether the driver has two back buffers; asking for them where it has not gives a poor one. */
  private static boolean hasStereo(GLProfile profile) {
    GLDrawableFactory factory = GLDrawableFactory.getFactory(profile);
    for (GLCapabilitiesImmutable available :
        factory.getAvailableCapabilities(factory.getDefaultDevice())) {
      if (available.getStereo() && available.isOnscreen() && available.getDepthBits() >= 24) {
        return true;
      }
    }
    return false;
  }

  /** Whether quad-buffered stereo can be had. */
  public boolean hasQuadBuffer() {
    return window.getChosenGLCapabilities() != null && window.getChosenGLCapabilities().getStereo();
  }

  private void draw() {
    boolean shown = window.isNativeValid() && window.getSurfaceWidth() > 0;
    if (shown && window.getSurfaceHeight() > 0) {
      window.display();
      noteSurface();
      onPicture.run();
    }
  }

  private void noteSurface() {
    if (firstSurfaceMillis == 0 && drawnTriangles > 0) {
      firstSurfaceMillis = System.currentTimeMillis();
    }
  }

  private void fail(Throwable cause) {
    failure = cause;
    end(End.FAILED);
  }

  private void end(End why) {
    boolean tell;
    synchronized (this) {
      tell = !ended;
      ended = true;
    }
    if (tell) {
      onEnd.accept(why);
    }
  }

  /** What made drawing fail; empty where it did not. */
  public Optional<Throwable> failure() {
    return Optional.ofNullable(failure);
  }

  /** For tests that do to it what a person or a driver does. */
  GLWindow glWindow() {
    return window;
  }

  /** What mouse and keys do. */
  public WindowInput input() {
    return input;
  }

  /** Pictures drawn so far. */
  public long redraws() {
    return drawing.drawn();
  }

  /** When a surface was first shown, as the system counts milliseconds; 0 before. */
  public long firstSurfaceMillis() {
    return firstSurfaceMillis;
  }

  /** How often what stands still was kept; right once drawing has ended. */
  public long stillKept() {
    return renderer.stillKept();
  }

  /** Bricks of surfaces left out, outside the view; right once drawing has ended. */
  public long skippedBricks() {
    return renderer.skippedBricks();
  }

  /** How often what stands still was drawn anew. */
  public long stillDrawn() {
    return renderer.stillDrawn();
  }

  /** Triangles drawn of all, for the overlay; empty before the first picture. */
  public String drawnTriangleText() {
    return initialized
        ? String.format(Locale.ROOT, "%,d of %,d triangles drawn", drawnTriangles, allTriangles)
        : "";
  }

  /** Gives those something to do who want to know of each picture shown; on the drawing thread. */
  public void onPicture(Runnable told) {
    onPicture = told;
  }

  /** Reads the next picture back and gives it to {@code taker} on the thread that draws. */
  public void takeSnapshot(Consumer<Picture> taker) {
    snapshot.set(taker);
    drawing.request();
  }

  /**
   * Says that the display went away: the owner is told, and nothing of the window is touched any
   * more, for whoever touches it hangs. Any thread.
   */
  public void displayLost() {
    displayLost = true;
    fail(new IllegalStateException("the display is gone"));
  }

  /** Closes the window; the owner is not told. May be called twice and by any thread. */
  @Override
  public void close() {
    synchronized (this) {
      ended = true;
    }
    if (displayLost) {
      drawing.abandon();
      return;
    }
    drawing.close();
    panel.ifPresent(ScenePanel::clear);
    Thread closing = new Thread(this::destroy, "palpate-close-window");
    closing.setDaemon(true);
    closing.start();
    try {
      closing.join(CLOSE_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void destroy() {
    try {
      window.destroy();
    } catch (GLException | NativeWindowException e) {
      failure = e; // the display or the driver went first, and the window with it
    }
  }

  private final class Ending extends WindowAdapter {
    @Override
    public void windowDestroyNotify(WindowEvent event) {
      end(End.CLOSED_BY_USER);
    }

    @Override
    public void windowRepaint(WindowUpdateEvent event) {
      drawing.request();
    }

    @Override
    public void windowResized(WindowEvent event) {
      drawing.request();
    }
  }

  private final class AnatomyVoxelizer implements GLEventListener {
    @Override
    public void init(GLAutoDrawable drawable) {
      // Comes again where the context was lost: all that was uploaded is uploaded anew.
      GL3 gl = drawable.getGL().getGL3();
      gl.setSwapInterval(0);
      renderer.init(gl);
      initialized = true;
    }

    @Override
    public void display(GLAutoDrawable drawable) {
      GL3 gl = drawable.getGL().getGL3();
      int width = drawable.getSurfaceWidth();
      int height = drawable.getSurfaceHeight();
      SceneState state = model.state();
      renderer.draw(gl, state, gl.getDefaultDrawFramebuffer(), width, height, 1);
      drawnTriangles = renderer.drawnTriangles();
      allTriangles = renderer.allTriangles();
      input.pick(at -> pick(gl, state, width, height, at));
      Consumer<Picture> taker = snapshot.getAndSet(null);
      if (taker != null) {
        taker.accept(PixelReader.read(gl, width, height));
      }
    }

    private Optional<Vec3> pick(GL3 gl, SceneState state, int width, int height, double[] at) {
      Vec3 place = new Vec3();
      return renderer.pick(gl, state, at[0], at[1], width, height, 1, place)
          ? Optional.of(place)
          : Optional.empty();
    }

    @Override
    public void reshape(GLAutoDrawable drawable, int x, int y, int width, int height) {
      drawing.request();
    }

    @Override
    public void dispose(GLAutoDrawable drawable) {
      if (initialized) {
        initialized = false;
        renderer.dispose(drawable.getGL().getGL3());
      }
    }
  }
}
