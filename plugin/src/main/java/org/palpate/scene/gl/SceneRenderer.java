package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneState;
import org.palpate.scene.Stereo;

/**
 * Draws a scene state. One thread, with the context current.
 *
 * <p>The static parts (surfaces, slices, background) are drawn into a picture of their own. It is
 * reused with its depth until they change. If only the device moved, a frame copies that picture
 * and draws a few hundred triangles.
 */
public final class SceneRenderer {
  private static final int EYES = 2;
  private static final double PIXEL_CENTRE = 0.5;

  private final boolean cullsOutsideView;
  private final boolean reusesStatic;
  private final GlFramebuffer[] staticPictures = new GlFramebuffer[EYES];
  private final long[] staticRevision = {-1, -1};
  private GlFramebuffer composed;

  /** A picture of one pixel without ghosts. */
  private GlFramebuffer picked;

  private GlProgram background;
  private GlProgram present;
  private ObjectPainter objects;
  private MarkPainter marks;
  private LandmarkPainter landmarks;
  private OverlayPainter overlay;
  private SlicePainter slices;
  private DeformationTexture deformation;
  private int[] emptyArray;
  private long staticReused;
  private double textScale = 1;

  /** Creates a renderer; {@link #init} prepares its context. */
  public SceneRenderer() {
    this(true, true);
  }

  /**
   * Creates a renderer without some of its skips, to measure them.
   *
   * @param cullsOutsideView whether bricks outside the view are not drawn
   * @param reusesStatic whether the picture of the static parts is reused
   */
  SceneRenderer(boolean cullsOutsideView, boolean reusesStatic) {
    this.cullsOutsideView = cullsOutsideView;
    this.reusesStatic = reusesStatic;
  }

  /**
   * Creates the resources of a context. Called again for a new context, after {@link #dispose} or
   * the loss of the old one.
   */
  public void init(GL3 gl) {
    background = new GlProgram(gl, Shaders.SCREEN_VERTEX, Shaders.BACKGROUND_FRAGMENT);
    present = new GlProgram(gl, Shaders.SCREEN_VERTEX, Shaders.PRESENT_FRAGMENT);
    deformation = new DeformationTexture(gl);
    objects = new ObjectPainter(gl, cullsOutsideView, deformation);
    marks = new MarkPainter(gl);
    landmarks = new LandmarkPainter(gl);
    overlay = new OverlayPainter(gl);
    slices = new SlicePainter(gl, deformation);
    composed = new GlFramebuffer();
    picked = new GlFramebuffer();
    emptyArray = new int[1];
    gl.glGenVertexArrays(1, emptyArray, 0);
    for (int eye = 0; eye < EYES; eye++) {
      staticPictures[eye] = new GlFramebuffer();
      staticRevision[eye] = -1;
    }
  }

  /** Sets the pixels of a window for one pixel of text, for displays with fine pixels. */
  public void setTextScale(double pixels) {
    textScale = pixels;
  }

  /** Returns the area of the legend in the last picture. Any thread. */
  public LegendArea legend() {
    return overlay == null ? LegendArea.NONE : overlay.legend();
  }

  /** Returns how many surface bricks were not drawn so far because they were outside the view. */
  public long culledBricks() {
    return objects == null ? 0 : objects.culledMeshes();
  }

  /** Returns how often the picture of the static parts was reused. */
  public long staticReused() {
    return staticReused;
  }

  /** Returns the number of triangles in the last picture of the static parts. */
  public long drawnTriangles() {
    return objects.drawnTriangles();
  }

  /** Returns the number of triangles of the visible segments, each at its finest complete level. */
  public long allTriangles() {
    return objects.allTriangles();
  }

  /**
   * Draws a picture.
   *
   * @param framebuffer the target, 0 for a window
   * @param width its width, pixels
   * @param height its height, pixels
   * @param scale edge of the square of samples that each pixel averages
   * @throws IllegalStateException if the graphics card has no memory left
   */
  public void draw(GL3 gl, SceneState state, int framebuffer, int width, int height, int scale) {
    Stereo stereo = state.look().stereo();
    int[] eyes = stereo == Stereo.OFF ? new int[] {0} : new int[] {-1, 1};
    for (int eye : eyes) {
      int eyeWidth = eyeWidth(stereo, width);
      if (eyeWidth > 0 && height > 0) {
        compose(gl, state, eye, eyeWidth * scale, height * scale, scale);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer);
        show(gl, stereo, eye, eyeWidth, height, scale);
      }
    }
    gl.glBindVertexArray(0);
    gl.glUseProgram(0);
    checkMemory(gl.glGetError());
  }

  /** Ends drawing if an error means that the picture is incomplete. */
  static void checkMemory(int error) {
    if (error == GL.GL_OUT_OF_MEMORY) {
      throw new IllegalStateException("the graphics card has no memory left");
    }
  }

  private void compose(GL3 gl, SceneState state, int eye, int width, int height, int scale) {
    Camera camera = state.camera();
    Matrix4 toEye = camera.view(eye);
    double aspect = (double) width / height;
    Matrix4 projection = camera.perspective(eye, aspect, state.middle(), state.radiusMm());
    GlFramebuffer target = staticPictures[Math.max(0, eye)];
    boolean resized = target.resize(gl, width, height);
    boolean changed = resized || staticRevision[Math.max(0, eye)] != state.staticRevision();
    if (!changed && reusesStatic) {
      staticReused++;
    } else {
      drawStatic(gl, state, target, toEye, projection);
      staticRevision[Math.max(0, eye)] = state.staticRevision();
    }
    composed.resize(gl, width, height);
    composed.copyFrom(gl, target);
    composed.bind(gl);
    landmarks.draw(gl, state, toEye, projection);
    state.marks().ifPresent(shown -> marks.draw(gl, state, shown, toEye, projection));
    overlay.draw(gl, state, projection.times(toEye), width, height, scale * textScale);
  }

  private void drawStatic(
      GL3 gl, SceneState state, GlFramebuffer target, Matrix4 toEye, Matrix4 projection) {
    target.bind(gl);
    gl.glDepthMask(true);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT | GL.GL_STENCIL_BUFFER_BIT);
    gl.glDisable(GL.GL_DEPTH_TEST);
    background.use(gl);
    background.setRgb(gl, "above", state.look().theme().above());
    background.setRgb(gl, "below", state.look().theme().below());
    drawScreen(gl);
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glEnable(GL.GL_STENCIL_TEST);
    gl.glStencilOp(GL.GL_KEEP, GL.GL_KEEP, GL.GL_REPLACE);
    gl.glStencilFunc(GL.GL_ALWAYS, GlFramebuffer.SLICE, GlFramebuffer.STENCIL_MASK);
    slices.draw(gl, state, toEye, projection);
    gl.glStencilFunc(GL.GL_ALWAYS, GlFramebuffer.NO_SLICE, GlFramebuffer.STENCIL_MASK);
    objects.draw(gl, state, toEye, projection);
    gl.glDisable(GL.GL_STENCIL_TEST);
  }

  private void show(GL3 gl, Stereo stereo, int eye, int width, int height, int scale) {
    int left = stereo == Stereo.SIDE_BY_SIDE && eye > 0 ? width : 0;
    if (stereo == Stereo.QUAD_BUFFER) {
      gl.glDrawBuffer(eye < 0 ? GL2GL3.GL_BACK_LEFT : GL2GL3.GL_BACK_RIGHT);
    }
    gl.glViewport(left, 0, width, height);
    gl.glDisable(GL.GL_DEPTH_TEST);
    gl.glActiveTexture(GL.GL_TEXTURE0);
    gl.glBindTexture(GL.GL_TEXTURE_2D, composed.colour());
    present.use(gl);
    present.set(gl, "picture", 0);
    present.set(gl, "scale", scale);
    present.set(gl, "corner", left, 0);
    present.set(gl, "eye", stereo == Stereo.ANAGLYPH ? eye : 0);
    if (stereo == Stereo.ANAGLYPH) {
      gl.glColorMask(eye < 0, eye > 0, eye > 0, true);
    }
    drawScreen(gl);
    gl.glColorMask(true, true, true, true);
    gl.glEnable(GL.GL_DEPTH_TEST);
  }

  private void drawScreen(GL3 gl) {
    gl.glBindVertexArray(emptyArray[0]);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
    gl.glBindVertexArray(0);
  }

  /**
   * Finds the point that a pixel shows, counted from the upper left of the window. Ghosts are left
   * out. Side by side, it is what the eye of that half sees; in other stereo modes what the left
   * eye sees.
   *
   * @return the point; empty if there is no surface
   */
  public Optional<PickedPoint> pick(
      GL3 gl, SceneState state, double x, double y, int width, int height, int scale) {
    Stereo stereo = state.look().stereo();
    int eyeWidth = eyeWidth(stereo, width);
    boolean rightHalf = eyeWidth < width && x >= eyeWidth;
    int eye = stereo == Stereo.OFF ? 0 : rightHalf ? 1 : -1;
    GlFramebuffer picture = staticPictures[Math.max(0, eye)];
    if (picture.framebuffer() == 0) {
      return Optional.empty();
    }
    double across = (rightHalf ? x - eyeWidth : x) + PIXEL_CENTRE;
    double aspect = (double) eyeWidth / height;
    double right = 2 * across / eyeWidth - 1;
    double up = 1 - 2 * (y + PIXEL_CENTRE) / height;
    double depth;
    if (state.hasGhosts()) {
      Camera camera = state.camera();
      Matrix4 projection = camera.perspective(eye, aspect, state.middle(), state.radiusMm());
      Matrix4 ofPixel = projection.zoomed(right, up, eyeWidth, height);
      depth = depthWithoutGhosts(gl, state, camera.view(eye), ofPixel);
    } else {
      depth = depth(gl, picture, across * scale, (height - PIXEL_CENTRE - y) * scale);
    }
    if (!(depth < 1)) {
      return Optional.empty();
    }
    Vec3 surface = Unprojection.toScene(state, eye, aspect, right, up, depth, new Vec3());
    return Optional.of(new PickedPoint(surface, state.camera().eye(eye)));
  }

  /** Draws one pixel without ghosts and returns its depth. Bricks beside it are left out. */
  private double depthWithoutGhosts(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 ofPixel) {
    int[] target = new int[1];
    gl.glGetIntegerv(GL2ES2.GL_DRAW_FRAMEBUFFER_BINDING, target, 0);
    picked.resize(gl, 1, 1);
    picked.bind(gl);
    gl.glDepthMask(true);
    gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
    gl.glEnable(GL.GL_DEPTH_TEST);
    slices.draw(gl, state, toEye, ofPixel);
    objects.drawWithoutGhosts(gl, state, toEye, ofPixel);
    double depth = depth(gl, picked, 0, 0);
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, target[0]);
    gl.glUseProgram(0);
    return depth;
  }

  private static int eyeWidth(Stereo stereo, int width) {
    return stereo == Stereo.SIDE_BY_SIDE ? width / 2 : width;
  }

  private static double depth(GL3 gl, GlFramebuffer picture, double column, double row) {
    FloatBuffer depth = Buffers.newDirectFloatBuffer(1);
    gl.glBindFramebuffer(GL2ES2.GL_READ_FRAMEBUFFER, picture.framebuffer());
    gl.glReadPixels((int) column, (int) row, 1, 1, GL2ES2.GL_DEPTH_COMPONENT, GL.GL_FLOAT, depth);
    gl.glBindFramebuffer(GL2ES2.GL_READ_FRAMEBUFFER, 0);
    return depth.get(0);
  }

  /** Releases all resources. */
  public void dispose(GL3 gl) {
    background.dispose(gl);
    present.dispose(gl);
    objects.dispose(gl);
    marks.dispose(gl);
    landmarks.dispose(gl);
    overlay.dispose(gl);
    slices.dispose(gl);
    deformation.dispose(gl);
    composed.dispose(gl);
    picked.dispose(gl);
    for (GlFramebuffer target : staticPictures) {
      target.dispose(gl);
    }
    gl.glDeleteVertexArrays(1, emptyArray, 0);
  }
}
