package org.palpate.examples;

import java.io.IOException;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.tool.MadeTool;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/** Presses a tool onto the torus phantom, and prints force and torque on the hand. */
public final class HoldTool {
  /**
   * Takes a tool and its clearance, for example {@code plate.stl body} or {@code box:9,5,2 -0.5}.
   */
  public static void main(String[] args) throws IOException {
    SegmentedVolume volume = Phantom.parse("torus:64").segments();
    Body torus = new Body("torus", volume.segments().get(0).bits(), volume.grid(), Mobility.FIXED);
    BodyScene scene = new BodyScene(List.of(torus));

    ToolRequest request = ToolRequest.parse(args[0], null, null, args[1]);
    MadeTool made = ToolMaker.make(request, scene.shortestEdgeMm(), CoordinateSystem.UNKNOWN);
    made.notes().forEach(System.out::println);
    System.out.println(
        made.tool().count() + " points, gap " + made.clearanceMm().orElse(0) + " mm");

    double maxStepMm = 8;
    RigidSettings settings = new RigidSettings(maxStepMm, made.clearances(scene), List.of(), true);
    RigidSolver solver = new RigidSolver(scene, made.tool(), settings);
    RigidCoupling coupling = RigidCoupling.of(made.tool(), 0.5);
    ToolMotion motion = new ToolMotion();
    Pose device = new Pose();
    device.translation.set(50, 32, 60); // above the ring
    solver.place(device, motion);
    Vec3 force = new Vec3();
    Vec3 torque = new Vec3();
    for (int ms = 0; ms <= 300; ms++) {
      device.translation.z = 60 - 0.1 * ms;
      solver.follow(device, motion);
      coupling.compute(motion.pose(), solver.target(), force, torque);
      if (ms % 100 == 0) {
        System.out.println(
            motion.contact() + " " + torque.length() + " N mm " + force.length() + " N");
      }
    }
  }
}
