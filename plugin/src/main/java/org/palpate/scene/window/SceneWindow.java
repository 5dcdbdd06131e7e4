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
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneState;
import org.palpate.scene.gl.SceneRenderer;

/**
 * A window on a scene. It draws when the scene requests it, on a thread of its own. Mouse and keys
 * move the camera and the device, and call actions.
 *
 * <p>Any thread opens and closes it. If it is closed, loses its context or its driver fails, it
 * reports that to its owner once and disturbs nothing else.
 */
public final class SceneWindow implements AutoCloseable {
  /** Reasons for the end of a window. */
  public enum End {
    /** The user closed the window. */
    CLOSED_BY_USER,
    /** Drawing failed; see {@link #failure}. */
    FAILED
  }

  /** The longest time to wait for a window to close; it may hang if its display is gone. */
  private static final long CLOSE_WAIT_MILLIS = 10_000;

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
  private final ReentrantLock showing = new ReentrantLock();
  private final Object destruction = new Object();
  private volatile boolean ended;
  private volatile boolean displayLost;

  /**
   * Creates a window that is not shown yet.
   *
   * @param onEnd receives the reason if the window ends other than by {@link #close}
   * @throws GraphicsException if there is no display or no driver, with the remedy
   */
  public SceneWindow(SceneModel model, String title, int width, int height, Consumer<End> onEnd)
      throws GraphicsException {
    this(model, Optional.empty(), onEnd);
    window.setTitle(title);
    double scale = DisplayScale.ofDesktop();
    window.setSize((int) Math.round(width * scale), (int) Math.round(height * scale));
  }

  /** Creates a window inside another program's window; otherwise as the other constructor. */
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
      input =
          new WindowInput(
              model, window::getSurfaceWidth, window::getSurfaceHeight, renderer::legend);
      window.addGLEventListener(new Drawing());
      window.addWindowListener(new WindowEvents());
      window.addMouseListener(input);
      window.addKeyListener(input.keys());
    } catch (GLException | NativeWindowException e) {
      throw GraphicsDriver.refused(e);
    }
  }

  /**
   * Shows the window and starts to draw. Call it once, after the input is set up.
   *
   * @throws GraphicsException if the driver refuses
   */
  public void show() throws GraphicsException {
    showing.lock();
    try {
      if (!ended) {
        open();
      }
    } catch (GLException | NativeWindowException e) {
      throw GraphicsDriver.refused(e);
    } finally {
      showing.unlock();
    }
  }

  private void open() {
    if (panel.isPresent()) {
      panel.get().put(window);
    } else {
      OpenWindows.add(this);
      window.setVisible(true);
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

  /**
   * Whether the driver has two back buffers. Requesting them from another driver gives a poor
   * configuration.
   */
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

  private void draw() {
    boolean shown = window.isNativeValid() && window.getSurfaceWidth() > 0;
    if (shown && window.getSurfaceHeight() > 0) {
      window.display();
      recordFirstSurface();
      onPicture.run();
    }
  }

  private void recordFirstSurface() {
    if (firstSurfaceMillis == 0 && drawnTriangles > 0) {
      firstSurfaceMillis = System.currentTimeMillis();
    }
  }

  private void fail(Throwable cause) {
    failure = cause;
    end(End.FAILED);
  }

  private void end(End reason) {
    boolean isFirst;
    synchronized (this) {
      isFirst = !ended;
      ended = true;
    }
    if (isFirst) {
      onEnd.accept(reason);
    }
  }

  /** Returns the reason why drawing failed; empty if it did not. */
  public Optional<Throwable> failure() {
    return Optional.ofNullable(failure);
  }

  /** Returns NEWT's window. Tests act on it as users and drivers do. */
  GLWindow glWindow() {
    return window;
  }

  /** Returns the actions of mouse and keys. */
  public WindowInput input() {
    return input;
  }

  /** Returns the number of pictures drawn. */
  public long redraws() {
    return drawing.drawn();
  }

  /** Returns when a surface was first shown, in milliseconds of the system clock; 0 before. */
  public long firstSurfaceMillis() {
    return firstSurfaceMillis;
  }

  /** Returns how often the picture of the static parts was reused; exact once drawing has ended. */
  public long staticReused() {
    return renderer.staticReused();
  }

  /**
   * Returns how many surface bricks were not drawn because they were outside the view; exact once
   * drawing has ended.
   */
  public long culledBricks() {
    return renderer.culledBricks();
  }

  /** Returns the number of triangles in the last picture; 0 before the first. */
  public long drawnTriangles() {
    return drawnTriangles;
  }

  /**
   * Returns the number of drawn and of all triangles for the overlay; empty before the first
   * picture.
   */
  public String drawnTriangleText() {
    return initialized
        ? String.format(Locale.ROOT, "%,d of %,d triangles drawn", drawnTriangles, allTriangles)
        : "";
  }

  /** Sets an action that runs after each picture, on the drawing thread. */
  public void onPicture(Runnable action) {
    onPicture = action;
  }

  /** Reads the next picture and passes it to {@code taker} on the drawing thread. */
  public void takeSnapshot(Consumer<Picture> taker) {
    snapshot.set(taker);
    drawing.request();
  }

  /**
   * Handles the loss of the display: reports it to the owner, and uses nothing of the window any
   * more, because any call would hang. Any thread.
   */
  public void displayLost() {
    displayLost = true;
    fail(new IllegalStateException("the display is gone"));
  }

  /** Closes the window as {@link #close} does, once it is shown if that goes on. */
  void closeAtEnd() {
    boolean isShown = false;
    try {
      isShown = showing.tryLock(CLOSE_WAIT_MILLIS, TimeUnit.MILLISECONDS);
      close();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      if (isShown) {
        showing.unlock();
      }
    }
  }

  /** Closes the window without a report to the owner. Any thread, any number of times. */
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
      closing.join(CLOSE_WAIT_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    OpenWindows.remove(this);
  }

  /**
   * Destroys the window if it is still there. When the process ends, the toolkit's own shutdown
   * hook has taken it away already, and destroying it again would fail.
   */
  private void destroy() {
    try {
      destroyOnce();
    } catch (GLException | NativeWindowException e) {
      failure = e; // the display or the driver went first, and the window with it
    }
  }

  private void destroyOnce() {
    synchronized (destruction) {
      if (window.isNativeValid()) {
        window.destroy();
      }
    }
  }

  private double textScale() {
    return panel.map(shown -> DisplayScale.of(shown.component())).orElseGet(this::ownTextScale);
  }

  private double ownTextScale() {
    double byNewt = (double) window.getSurfaceWidth() / Math.max(1, window.getWidth());
    return Math.max(1, byNewt) * DisplayScale.ofDesktop();
  }

  private final class WindowEvents extends WindowAdapter {
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

  private final class Drawing implements GLEventListener {
    @Override
    public void init(GLAutoDrawable drawable) {
      // Called again if the context was lost; then everything is uploaded again.
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
      renderer.setTextScale(textScale());
      renderer.draw(gl, state, gl.getDefaultDrawFramebuffer(), width, height, 1);
      drawnTriangles = renderer.drawnTriangles();
      allTriangles = renderer.allTriangles();
      input.pick((x, y) -> renderer.pick(gl, state, x, y, width, height, 1));
      Consumer<Picture> taker = snapshot.getAndSet(null);
      if (taker != null) {
        taker.accept(PixelReader.read(gl, width, height));
      }
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
