package org.palpate.benchmarks.rigid;

import java.util.List;
import org.palpate.benchmarks.shell.PointShell;
import org.palpate.benchmarks.shell.ShellResponse;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * The tool of the paper of 2013: an interaction point for each point of the tool, moved by the
 * paper's solver independently of the others. The force is the mean of the points' springs.
 */
final class PaperPeer implements PeerTool {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private final CollisionScene scene;
  private final PointShell shell;
  private final ShellResponse response;
  private final RigidTransform pose =
      new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
  private final Vec3 at = new Vec3();

  PaperPeer(BitCube bits, RigidTool tool) {
    scene = new CollisionScene(List.of(bits));
    double[] points = new double[3 * tool.count()];
    for (int n = 0; n < tool.count(); n++) {
      points[3 * n] = tool.x(n);
      points[3 * n + 1] = tool.y(n);
      points[3 * n + 2] = tool.z(n);
    }
    shell = new PointShell(points);
    response =
        new ShellResponse(
            tool.count(),
            UNIT,
            () ->
                new PaperSolver(
                    new SampledRayCaster(1),
                    UNIT,
                    ToolClearance.MAX_STEP_MM,
                    BorderVoxels.onTheFly()));
  }

  @Override
  public void place(Pose start) {
    shell.place(start.transform(pose), UNIT);
    response.place(scene, shell);
  }

  @Override
  public void follow(Pose device) {
    shell.place(device.transform(pose), UNIT);
    response.follow(scene, shell, 0, shell.count());
  }

  @Override
  public Vec3 force(Pose device, Vec3 dest) {
    dest.set(0, 0, 0);
    for (int n = 0; n < shell.count(); n++) {
      response.point(n).position.sub(shell.now(n, at), at);
      dest.add(at, dest);
    }
    return dest.mul(1.0 / shell.count(), dest);
  }

  @Override
  public int count() {
    return shell.count();
  }

  @Override
  public Vec3 point(int index, Vec3 dest) {
    return dest.set(response.point(index).position);
  }
}
