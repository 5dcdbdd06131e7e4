package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.body.BodyScene;
import org.palpate.edit.EditQueue;
import org.palpate.force.EffectSite;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.ToolFrame;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;

/**
 * One set-up of the closed loop with a tool in six degrees of freedom.
 *
 * @param device the device; its largest torque is taken to be its force at the grip radius
 * @param grip the person
 * @param sampling rate and delay
 * @param held the tool
 */
record ToolTrial(DeviceModel device, Grip grip, Sampling sampling, HeldTool held)
    implements HeldTrial {
  private static final double N_PER_MM = 1e-3;
  private static final double MAX_STEP_MM = 8 * TouchedShape.VOXEL_MM;

  @Override
  public String heldName() {
    return held.name();
  }

  @Override
  public double lengthMm() {
    return held.lengthMm();
  }

  @Override
  public double rmsRadiusMm() {
    return held.tool().rmsRadiusMm();
  }

  /** Runs the trial with a stiffness, N/m; the rotational stiffness is that of a session. */
  @Override
  public Outcome run(double newtonPerM) {
    return run(newtonPerM, !held.effects().isEmpty(), ToolFramePublisher.NONE);
  }

  @Override
  public double givenMillijoule(double newtonPerM) {
    HandWork work = new HandWork(1);
    run(newtonPerM, true, work);
    return work.millijoule();
  }

  /**
   * Runs the trial.
   *
   * @param settles whether the hand waits until effects and the force of a session are on
   */
  private Outcome run(double newtonPerM, boolean settles, ToolFramePublisher publisher) {
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, held.touchMm(), new Vec3(0, 0, -1));
    Plant plant = loop.turningPlant(held.orientation());
    FrameSettings settings = ClosedLoop.settings(plant.specification(), newtonPerM, true);
    BodyScene bodies = new BodyScene(List.of(held.solid()));
    RigidTool tool = held.tool();
    RigidCoupling coupling = RigidCoupling.of(tool, newtonPerM * N_PER_MM);
    ToolFrame frame =
        new ToolFrame(
            settles ? new SettlingDevice(plant, sampling) : plant,
            bodies,
            new RigidSolver(bodies, tool, RigidSettings.of(MAX_STEP_MM, Clearance.POINTS)),
            coupling,
            settings,
            EditQueue.ofBodies(bodies.grids()),
            publisher);
    held.proposal(coupling).ifPresent(frame::use);
    EffectSite site = HeldTrial.site(coupling, settings);
    frame.requestEffects(held.effects().stream().map(plan -> plan.make(site)).toList());
    return loop.run(plant, frame);
  }
}
