package org.palpate.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.palpate.scene.Matrix4;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.Palette;
import org.palpate.scene.SceneState;

/** Draws landmarks as small balls. {@link OverlayPainter} draws their names. */
final class LandmarkPainter {
  /** Radius of a ball over the camera's distance. */
  private static final double SIZE = 0.0038;

  /** Opacity of a ball behind a surface. */
  private static final double HIDDEN_OPACITY = 0.3;

  private final MarkProgram program;
  private final MarkMesh mesh = new MarkMesh();

  /** Compiles the program. */
  LandmarkPainter(GL3 gl) {
    program = new MarkProgram(gl);
  }

  /** Draws landmarks over a picture with its depth; hidden parts are faint. */
  void draw(GL3 gl, SceneState state, Matrix4 toEye, Matrix4 projection) {
    List<NamedPoint> landmarks = state.landmarks();
    if (landmarks.isEmpty()) {
      return;
    }
    mesh.clear();
    mesh.colour(Palette.LANDMARK, 1);
    double radius = SIZE * state.camera().distanceMm();
    landmarks.forEach(mark -> mesh.ball(mark.position(), radius));
    program.use(gl, toEye, projection);
    program.draw(gl, mesh, 0, HIDDEN_OPACITY);
  }

  /** Releases the program. */
  void dispose(GL3 gl) {
    program.dispose(gl);
  }
}
