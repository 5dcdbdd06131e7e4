package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class RigidAllocationTest {
  private static final int FRAMES = 20_000;

  /** The JVM itself allocates a little when it links or recompiles code that frames have met. */
  private static final int MOST_ROUNDS = 8;

  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  @Test
  void warmFramesOfAToolAllocateNothing() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BodyScene scene = ToolScenes.clutter(random, 2);
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 5), 0.8);
    RigidSettings settings = RigidSettings.ofWholeBodies(5, scene, tool);
    RigidSolver solver = new RigidSolver(scene, tool, settings);
    RigidCoupling coupling = RigidCoupling.of(tool, 1);
    ToolMotion motion = new ToolMotion();
    solver.place(RandomGeometry.pose(random, 30), motion);
    Pose[] device = new Pose[1000];
    HostilePoses hostile = new HostilePoses(random, 25);
    for (int n = 0; n < device.length; n++) {
      device[n] = new Pose().set(hostile.next());
    }
    Vec3 force = new Vec3();
    Vec3 torque = new Vec3();
    List<Long> allocated = new ArrayList<>();
    int contacts = 0;
    for (int round = 0; round < MOST_ROUNDS; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int frame = 0; frame < FRAMES; frame++) {
        solver.follow(device[frame % device.length], motion);
        coupling.compute(motion.pose(), solver.target(), force, torque);
        contacts += motion.contact() ? 1 : 0;
      }
      allocated.add(threads.getCurrentThreadAllocatedBytes() - before);
      if (allocated.get(round) == 0) {
        break;
      }
    }
    assertTrue(contacts > FRAMES / 10);
    assertEquals(0, allocated.get(allocated.size() - 1), "bytes by rounds: " + allocated);
  }
}
