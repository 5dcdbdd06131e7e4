package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.edit.EditQueue;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop with a rod in six degrees of freedom. The rod is held aslant, so
 * that one end meets a flat wall first and the contact turns the hand.
 *
 * @param device the device; its largest torque is taken to be its force at the grip radius
 * @param grip the person
 * @param sampling rate and delay
 * @param lengthMm the distance between the centres of the rod's caps
 */
public record ToolTrial(DeviceModel device, Grip grip, Sampling sampling, double lengthMm)
    implements LoopTrial {
  private static final double ROD_RADIUS_MM = 3;
  private static final double TILT_RAD = 0.15;
  private static final int EDGE = 128;
  private static final double COVER_RADIUS_MM = 0.5;
  private static final double MAX_STEP_MM = 8 * TouchedShape.VOXEL_MM;

  @Override
  public List<Object> conditionCells() {
    return List.of(lengthMm, rmsRadiusMm());
  }

  /** Runs the trial with a stiffness, N/m; the rotational stiffness is that of a session. */
  @Override
  public Outcome run(double newtonPerM) {
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, touchMm(), new Vec3(0, 0, -1));
    Plant plant = loop.turningPlant(upright());
    FrameSettings settings = ClosedLoop.settings(plant.specification(), newtonPerM, true);
    BodyScene wall = wall();
    RigidTool rod = rod();
    ToolFrame frame =
        new ToolFrame(
            plant,
            wall,
            new RigidSolver(wall, rod, RigidSettings.of(MAX_STEP_MM, Clearance.POINTS)),
            RigidCoupling.of(rod, newtonPerM * 1e-3),
            settings,
            EditQueue.ofBodies(wall.grids()),
            ToolFramePublisher.NONE);
    return loop.run(plant, frame);
  }

  /** Returns the root mean square distance of the rod's matter from its centre, mm. */
  public double rmsRadiusMm() {
    return rod().rmsRadiusMm();
  }

  private RigidTool rod() {
    return ToolSampler.ofShape(RodShape.capsule(ROD_RADIUS_MM, lengthMm), COVER_RADIUS_MM);
  }

  /** Returns the orientation that lays the rod, which is along z, nearly flat on the wall. */
  private static Quaternion upright() {
    return new Quaternion().setRotationVector(new Vec3(0, Math.PI / 2 - TILT_RAD, 0));
  }

  /** Returns the rod's centre when its lower end meets the wall. */
  private Vec3 touchMm() {
    double middleMm = EDGE / 2 * TouchedShape.VOXEL_MM;
    double lowMm = 0.5 * lengthMm * Math.sin(TILT_RAD) + ROD_RADIUS_MM;
    return new Vec3(middleMm, middleMm, middleMm + lowMm);
  }

  private static BodyScene wall() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < EDGE / 2; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          bits.set(i, j, k);
        }
      }
    }
    double voxel = TouchedShape.VOXEL_MM;
    VoxelGrid grid =
        new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(voxel, voxel, voxel), RigidTransform.identity());
    return new BodyScene(List.of(new Body("wall", bits, grid, Mobility.FIXED)));
  }
}
