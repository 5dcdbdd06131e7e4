package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.edit.EditQueue;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveTool;
import org.palpate.force.ToolProposal;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.force.needle.NeedleTrack;
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
 * One set-up of the closed loop with a tool in six degrees of freedom. A rod is held aslant, so
 * that one end meets a flat wall first and the contact turns the hand. A needle is pushed upright
 * into tissue over bone.
 *
 * @param device the device; its largest torque is taken to be its force at the grip radius
 * @param grip the person
 * @param sampling rate and delay
 * @param held the tool
 */
public record ToolTrial(DeviceModel device, Grip grip, Sampling sampling, Held held)
    implements LoopTrial {
  private static final double N_PER_MM = 1e-3;
  private static final double ROD_RADIUS_MM = 3;
  private static final double TILT_RAD = 0.15;
  private static final int EDGE = 128;
  private static final double COVER_RADIUS_MM = 0.5;
  private static final double MAX_STEP_MM = 8 * TouchedShape.VOXEL_MM;

  private static final double NEEDLE_RADIUS_MM = 0.5;
  private static final double NEEDLE_LENGTH_MM = 30;

  /** The layers of voxels of the wall, and of the bone, from the lowest one up. */
  private static final int WALL_LAYERS = EDGE / 2;

  private static final int BONE_LAYERS = 8;

  /** The layer at which the tissue ends; it begins on the bone. */
  private static final int TISSUE_TOP = 120;

  private static final Body WALL = body("wall", WALL_LAYERS);
  private static final Body BONE = body("bone", BONE_LAYERS);

  /** Soft enough for the weakest device: puncture 0.5 N, cutting 0.1 N, shaft 0.02 N/mm. */
  private static final NeedleTissue TISSUE =
      new NeedleTissue(layers(BONE_LAYERS, TISSUE_TOP), 0.5, 0.1, 0.02);

  /**
   * The tool that the hand holds.
   *
   * @param name the name in tables
   * @param lengthMm the distance between the centres of the caps
   * @param massKg its mass; empty without one
   * @param isNeedle whether it enters tissue
   */
  public record Held(String name, double lengthMm, OptionalDouble massKg, boolean isNeedle) {
    /** The needle. */
    static final Held NEEDLE =
        new Held("needle", NEEDLE_LENGTH_MM - 2 * NEEDLE_RADIUS_MM, OptionalDouble.empty(), true);

    /** Returns a rod without mass. */
    static Held rod(double lengthMm) {
      return new Held("rod", lengthMm, OptionalDouble.empty(), false);
    }

    /** Returns a rod with mass, which has inertia against motion and turning. */
    static Held rod(double lengthMm, double kg) {
      return new Held("rod of " + kg + " kg", lengthMm, OptionalDouble.of(kg), false);
    }
  }

  @Override
  public List<Object> conditionCells() {
    return List.of(held.name(), held.lengthMm(), rmsRadiusMm());
  }

  /** Runs the trial with a stiffness, N/m; the rotational stiffness is that of a session. */
  @Override
  public Outcome run(double newtonPerM) {
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, touchMm(), new Vec3(0, 0, -1));
    Plant plant = loop.turningPlant(orientation());
    FrameSettings settings = ClosedLoop.settings(plant.specification(), newtonPerM, true);
    BodyScene bodies = new BodyScene(List.of(held.isNeedle() ? BONE : WALL));
    RigidTool tool = tool();
    RigidCoupling coupling = RigidCoupling.of(tool, newtonPerM * N_PER_MM);
    ToolFrame frame =
        new ToolFrame(
            plant,
            bodies,
            new RigidSolver(bodies, tool, RigidSettings.of(MAX_STEP_MM, Clearance.POINTS)),
            coupling,
            settings,
            EditQueue.ofBodies(bodies.grids()),
            ToolFramePublisher.NONE);
    proposal(tool, coupling).ifPresent(frame::use);
    return loop.run(plant, frame);
  }

  /** Returns the proposal of a needle or of a mass; none for a rod without mass. */
  private Optional<ToolProposal> proposal(RigidTool tool, RigidCoupling coupling) {
    if (held.isNeedle()) {
      Vec3 tip = new Vec3(0, 0, -NEEDLE_LENGTH_MM / 2);
      return Optional.of(
          new NeedleTrack(
              List.of(TISSUE),
              BONE.grid(),
              tip,
              NEEDLE_LENGTH_MM,
              coupling.stiffnessNewtonPerMm()));
    }
    if (held.massKg().isEmpty()) {
      return Optional.empty();
    }
    MassSettings mass = new MassSettings(held.massKg().getAsDouble(), new Vec3());
    return Optional.of(new MassiveTool(tool, coupling, ClosedLoop.FRICTION, mass));
  }

  /** Returns the root mean square distance of the tool's matter from its centre, mm. */
  public double rmsRadiusMm() {
    return tool().rmsRadiusMm();
  }

  private RigidTool tool() {
    double radiusMm = held.isNeedle() ? NEEDLE_RADIUS_MM : ROD_RADIUS_MM;
    return ToolSampler.ofShape(RodShape.capsule(radiusMm, held.lengthMm()), COVER_RADIUS_MM);
  }

  /** Returns the orientation: a needle is along z, and a rod lies nearly flat on the wall. */
  private Quaternion orientation() {
    double turnRad = held.isNeedle() ? 0 : Math.PI / 2 - TILT_RAD;
    return new Quaternion().setRotationVector(new Vec3(0, turnRad, 0));
  }

  /** Returns the centre when the lower end meets the wall or the tissue. */
  private Vec3 touchMm() {
    double voxelMm = TouchedShape.VOXEL_MM;
    double lowMm =
        held.isNeedle()
            ? TISSUE_TOP * voxelMm + NEEDLE_LENGTH_MM / 2
            : WALL_LAYERS * voxelMm + 0.5 * held.lengthMm() * Math.sin(TILT_RAD) + ROD_RADIUS_MM;
    return new Vec3(EDGE / 2 * voxelMm, EDGE / 2 * voxelMm, lowMm);
  }

  private static BitCube layers(int low, int high) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = low; k < high; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private static Body body(String name, int layers) {
    double voxel = TouchedShape.VOXEL_MM;
    VoxelGrid grid =
        new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(voxel, voxel, voxel), RigidTransform.identity());
    return new Body(name, layers(0, layers), grid, Mobility.FIXED);
  }
}
