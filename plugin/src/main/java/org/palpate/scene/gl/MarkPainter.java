package org.palpate.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Matrix4;
import org.palpate.scene.Palette;
import org.palpate.scene.SceneState;
import org.palpate.scene.ToolMarks;
import org.palpate.scene.TouchMarks;

/**
 * Draws the device, the interaction point, the spring between them, the force and the trail. Draws
 * the sample points, the contacts and the torque of a rigid tool.
 */
final class MarkPainter {
  /** Radius of the interaction point's ball over the camera's distance. */
  private static final double POINT_SIZE = 0.0055;

  /** Length of the arrow of one newton over the camera's distance. */
  private static final double ARROW_SIZE = 0.035;

  private static final double MAX_ARROW_SIZE = 0.2;

  /** Opacity of a mark behind a surface. */
  private static final double HIDDEN_OPACITY = 0.42;

  private final MarkProgram program;

  /** The device and the spring. */
  private final MarkMesh device = new MarkMesh();

  /**
   * The interaction point, its trail and the force. They lie on the surface, so it never hides
   * them.
   */
  private final MarkMesh point = new MarkMesh();

  /** The sample points of a rigid tool, its contacts and its torque. */
  private final MarkMesh tool = new MarkMesh();

  /** Compiles the program. */
  MarkPainter(GL3 gl) {
    program = new MarkProgram(gl);
  }

  /** Draws the marks over a picture with its depth; hidden parts are faint. */
  void draw(GL3 gl, SceneState state, TouchMarks shown, Matrix4 toEye, Matrix4 projection) {
    double size = POINT_SIZE * state.camera().distanceMm();
    buildDevice(shown, size);
    buildPoint(shown, size, state.camera().distanceMm());
    tool.clear();
    shown.tool().ifPresent(held -> buildTool(held, size));
    program.use(gl, toEye, projection);
    program.draw(gl, device, 0, HIDDEN_OPACITY);
    if (tool.vertexCount() > 0) {
      program.draw(gl, tool, state.detailMm(), HIDDEN_OPACITY);
    }
    program.draw(gl, point, state.detailMm(), HIDDEN_OPACITY);
  }

  private void buildDevice(TouchMarks shown, double size) {
    device.clear();
    double stretch = shown.device().sub(shown.point(), new Vec3()).length();
    if (stretch > 2 * size) {
      int turns = (int) Math.max(3, Math.min(14, stretch / size));
      device
          .colour(Palette.SPRING, 1)
          .spring(shown.point(), shown.device(), turns, 0.45 * size, 0.13 * size);
    }
    device.colour(Palette.DEVICE, 1).ball(shown.device(), 0.75 * size);
  }

  private void buildTool(ToolMarks held, double size) {
    tool.colour(Palette.TOOL, 1);
    held.points().forEach(point -> tool.dot(point, 0.22 * size));
    tool.colour(Palette.CONTACT, 1);
    held.contacts().forEach(contact -> tool.ball(contact, 0.6 * size));
    List<Vec3> arc = held.torqueArc();
    if (arc.size() > 1) {
      tool.colour(Palette.TORQUE, 1).tube(arc, 0.25 * size);
      Vec3 end = arc.get(arc.size() - 1);
      Vec3 along = end.sub(arc.get(arc.size() - 2), new Vec3());
      along.mul(3 * size / along.length(), along);
      tool.arrow(end, along.add(end, along), 0.25 * size);
    }
  }

  private void buildPoint(TouchMarks shown, double size, double distance) {
    point.clear();
    point.colour(Palette.TRAIL, 1).tube(shown.trail(), 0.28 * size);
    point.colour(Palette.POINT, 1).ball(shown.point(), size);
    double newton = shown.forceNewton().length();
    if (newton > 0) {
      double length = Math.min(ARROW_SIZE * newton, MAX_ARROW_SIZE) * distance;
      Vec3 along = shown.forceNewton().mul(length / newton, new Vec3());
      Vec3 tip = along.add(shown.point(), along);
      point.colour(Palette.FORCE, 1).arrow(shown.point(), tip, 0.4 * size);
    }
  }

  /** Releases the program. */
  void dispose(GL3 gl) {
    program.dispose(gl);
  }
}
