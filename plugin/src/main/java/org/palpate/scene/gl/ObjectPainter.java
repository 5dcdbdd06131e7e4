package org.palpate.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Deformation;
import org.palpate.scene.DeformationColour;
import org.palpate.scene.DeformationColour.Measure;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneObject;
import org.palpate.scene.SceneState;
import org.palpate.scene.SceneState.DrawnObject;
import org.palpate.scene.surface.SurfaceBrick;

/** Draws surfaces: uploads new and changed bricks, and draws those in view. */
final class ObjectPainter {
  /** The most triangles that are drawn at full resolution while the camera moves. */
  private static final long MAX_MOVING_TRIANGLES = 400_000;

  private final GlProgram program;
  private final TintTexture tint;
  private final boolean cullsOutsideView;
  private final DeformationTexture texture;
  private final Map<SceneObject, List<Map<Integer, GlMesh>>> meshes = new HashMap<>();

  /** The deformation of the picture that is being drawn. */
  private Optional<Deformation> deformation = Optional.empty();

  private long drawnTriangles;
  private long allTriangles;
  private long culledMeshes;

  /**
   * Compiles the program.
   *
   * @param texture the deformation of each picture
   * @param cullsOutsideView whether bricks outside the view are not drawn
   */
  ObjectPainter(GL3 gl, boolean cullsOutsideView, DeformationTexture texture) {
    this.cullsOutsideView = cullsOutsideView;
    this.texture = texture;
    program = new GlProgram(gl, Shaders.MESH_VERTEX, Shaders.MESH_FRAGMENT);
    tint = new TintTexture(gl);
  }

  /**
   * Returns the number of triangles drawn in the last picture. Transparent ones count once,
   * although they are sent twice.
   */
  long drawnTriangles() {
    return drawnTriangles;
  }

  /** Returns how many bricks were not drawn so far because they were outside the view. */
  long culledMeshes() {
    return culledMeshes;
  }

  /** Returns the number of triangles of the visible segments, each at its finest complete level. */
  long allTriangles() {
    return allTriangles;
  }

  /**
   * Draws the opaque segments, then the transparent ones from back to front. Of a transparent
   * segment only the nearest surface is drawn.
   */
  void draw(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    drawnTriangles = 0;
    allTriangles = state.objects().stream().mapToLong(o -> finestTriangles(o.object())).sum();
    begin(gl, state, toEye, projection);
    List<DrawnObject> transparent = new ArrayList<>();
    for (DrawnObject object : state.objects()) {
      if (object.opacity() >= 1) {
        drawObject(gl, state, object, toEye, projection);
      } else {
        transparent.add(object);
      }
    }
    transparent.sort(Comparator.comparingDouble(o -> depth(o, toEye)));
    transparent.forEach(object -> drawTransparent(gl, state, object, toEye, projection));
  }

  /** Draws only what the mouse may meet, which is all but ghosts, as if it were opaque. */
  void drawWithoutGhosts(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    long drawnBefore = drawnTriangles;
    long culledBefore = culledMeshes;
    begin(gl, state, toEye, projection);
    for (DrawnObject object : state.objects()) {
      if (!object.isGhost()) {
        drawObject(gl, state, object, toEye, projection);
      }
    }
    drawnTriangles = drawnBefore;
    culledMeshes = culledBefore;
  }

  private void begin(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    program.use(gl);
    program.set(gl, "projection", projection);
    setClip(gl, state, toEye);
    deformation = texture.use(gl, program, state.deformation());
    setDeformationColour(gl, state.look().deformed());
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_LESS);
    gl.glDepthMask(true);
  }

  /** Sets the value that colours deformed surfaces; the program knows measures by number. */
  private void setDeformationColour(GL3 gl, Optional<DeformationColour> wanted) {
    int number = wanted.map(by -> by.measure() == Measure.DISPLACEMENT ? 1 : 2).orElse(0);
    program.set(gl, "deformedBy", number);
    program.set(gl, "deformedMost", wanted.map(DeformationColour::most).orElse(1.0));
  }

  /** Sets the clipping plane. Without one the normal is zero, so that nothing is hidden. */
  private void setClip(GL3 gl, SceneState state, Matrix4 toEye) {
    Vec3 normal = new Vec3();
    double distance = 1;
    if (state.clip().isPresent()) {
      Vec3 from = new Vec3();
      toEye.project(state.clip().get().point(), from);
      Vec3 ahead = state.clip().get().point().add(state.clip().get().normal(), new Vec3());
      toEye.project(ahead, normal);
      normal.sub(from, normal);
      distance = normal.dot(from);
    }
    program.set(gl, "clipNormal", normal.x, normal.y, normal.z);
    program.set(gl, "clipDistance", distance);
  }

  private static long finestTriangles(SceneObject object) {
    int finest = object.finestComplete();
    return finest < 0 ? 0 : object.triangleCount(finest);
  }

  private static double depth(DrawnObject object, Matrix4 toEye) {
    Vec3 middle = object.object().corner(0);
    middle.add(object.object().corner(7), middle).mul(0.5, middle);
    object.pose().transform(middle, middle);
    toEye.project(middle, middle);
    return middle.z;
  }

  private void drawTransparent(
      GL3 gl, SceneState state, DrawnObject object, Matrix4 toEye, Matrix4 projection) {
    long drawnBefore = drawnTriangles;
    long culledBefore = culledMeshes;
    gl.glColorMask(false, false, false, false);
    drawObject(gl, state, object, toEye, projection);
    gl.glColorMask(true, true, true, true);
    // The second pass draws the same in colour, so the first is not counted.
    drawnTriangles = drawnBefore;
    culledMeshes = culledBefore;
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthFunc(GL.GL_EQUAL);
    drawObject(gl, state, object, toEye, projection);
    gl.glDepthFunc(GL.GL_LESS);
    gl.glDisable(GL.GL_BLEND);
  }

  private void drawObject(
      GL3 gl, SceneState state, DrawnObject object, Matrix4 toEye, Matrix4 projection) {
    int level = level(state, object.object());
    if (level < 0) {
      return;
    }
    Map<Integer, GlMesh> uploaded = upload(gl, object.object(), level);
    Matrix4 gridToEye = toEye.times(Matrix4.of(object.pose()));
    Matrix4 toClip = projection.times(gridToEye);
    program.set(gl, "toEye", gridToEye);
    program.setRgb(gl, "colour", object.rgb());
    program.set(gl, "opacity", object.opacity());
    tint.set(gl, program, object.tint());
    gl.glFrontFace(object.pose().isMirrored() ? GL.GL_CW : GL.GL_CCW);
    double marginMm = deformation.map(Deformation::longestMm).orElse(0.0);
    for (GlMesh mesh : uploaded.values()) {
      if (cullsOutsideView && mesh.isOutside(toClip, marginMm)) {
        culledMeshes++;
      } else {
        deformation.ifPresent(moving -> program.set(gl, "deforms", mesh.isMovedBy(moving) ? 1 : 0));
        mesh.draw(gl);
        drawnTriangles += mesh.triangleCount();
      }
    }
    gl.glBindVertexArray(0);
    gl.glFrontFace(GL.GL_CCW);
  }

  private int level(SceneState state, SceneObject object) {
    int finest = object.finestComplete();
    if (finest < 0 || !state.moving()) {
      return finest;
    }
    int level = finest;
    while (allTriangles >> (2 * level) > MAX_MOVING_TRIANGLES
        && level + 1 < SceneObject.LEVELS
        && object.isComplete(level + 1)) {
      level++;
    }
    return level;
  }

  private Map<Integer, GlMesh> upload(GL3 gl, SceneObject object, int level) {
    Map<Integer, GlMesh> uploaded =
        meshes
            .computeIfAbsent(
                object, key -> List.of(new HashMap<>(), new HashMap<>(), new HashMap<>()))
            .get(level);
    Map<Integer, SurfaceBrick> current = object.bricks(level);
    dropStale(gl, uploaded, current);
    current.forEach(
        (number, brick) -> uploaded.computeIfAbsent(number, key -> new GlMesh(gl, brick)));
    return uploaded;
  }

  private static void dropStale(
      GL3 gl, Map<Integer, GlMesh> uploaded, Map<Integer, SurfaceBrick> current) {
    for (Iterator<Map.Entry<Integer, GlMesh>> all = uploaded.entrySet().iterator();
        all.hasNext(); ) {
      Map.Entry<Integer, GlMesh> entry = all.next();
      if (!entry.getValue().shows(current.get(entry.getKey()))) {
        entry.getValue().dispose(gl);
        all.remove();
      }
    }
  }

  /** Releases all meshes and the program. */
  void dispose(GL3 gl) {
    for (List<Map<Integer, GlMesh>> levels : meshes.values()) {
      levels.forEach(level -> level.values().forEach(mesh -> mesh.dispose(gl)));
    }
    meshes.clear();
    tint.dispose(gl);
    program.dispose(gl);
  }
}
