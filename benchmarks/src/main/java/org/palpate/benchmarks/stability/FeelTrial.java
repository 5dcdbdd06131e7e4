package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.edit.EditQueue;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.force.effect.Effects;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop with guides, effects or a mass on a flat wall.
 *
 * @param device the device
 * @param grip the person
 * @param sampling rate and delay
 * @param feel the guide, effect or mass that the hand feels
 */
public record FeelTrial(DeviceModel device, Grip grip, Sampling sampling, Feel feel)
    implements EnergyTrial {
  private static final double VOXEL = TouchedShape.VOXEL_MM;
  private static final GridMetric METRIC = new GridMetric(VOXEL, VOXEL, VOXEL);
  private static final int EDGE = 32;

  private static final double N_PER_MM = 1e-3;

  /** The hand presses aslant, so that it also slides, without friction. */
  private static final Vec3 INWARD = new Vec3(0.6, 0, -0.8);

  /** The distance of the hand from the touched position at the start. */
  private static final double START_MM = 2;

  /** A guide keeps the hand in a ball of this radius around the start, which the wall cuts. */
  private static final double BALL_MM = 2.5;

  /** Effects of the wall begin below the start. */
  private static final double REACH_MM = 1.3;

  private static final TouchedShape WALL = TouchedShape.wall();
  private static final List<Feel> FEELS = newFeels();

  /**
   * A guide, effect or mass that the hand feels beside contact.
   *
   * @param name the name in tables
   * @param plans guides and effects
   * @param massKg the mass of the point, if it has one
   * @param materials tissue from grey values, if there is any
   * @param detailed whether it has detail that a faster frame could resolve
   * @param driven whether a force follows time; such an effect is active
   */
  public record Feel(
      String name,
      List<EffectPlan> plans,
      OptionalDouble massKg,
      Optional<GreyMaterials> materials,
      boolean detailed,
      boolean driven) {
    private static Feel ofPlans(
        String name, boolean detailed, boolean driven, EffectPlan... plans) {
      return new Feel(
          name, List.of(plans), OptionalDouble.empty(), Optional.empty(), detailed, driven);
    }

    private static Feel of(String name, EffectPlan... plans) {
      return ofPlans(name, false, false, plans);
    }

    private static Feel ofMass(double kg) {
      String name = "mass " + kg + " kg";
      return new Feel(name, List.of(), OptionalDouble.of(kg), Optional.empty(), false, false);
    }

    private static Feel ofMaterials(String name, GreyMaterials materials) {
      return new Feel(
          name, List.of(), OptionalDouble.empty(), Optional.of(materials), false, false);
    }

    /** Whether it is also studied above 1 kHz: plain contact, mass, and detail. */
    boolean isStudiedFast() {
      return detailed || (plans.isEmpty() && materials.isEmpty());
    }
  }

  /** Returns the compared guides, effects and masses; the first is plain contact. */
  public static List<Feel> feels() {
    return FEELS;
  }

  private static List<Feel> newFeels() {
    Vec3 start = INWARD.mul(-START_MM, new Vec3()).add(WALL.touchMm(), new Vec3());
    Vec3 aside = new Vec3(start.x + 3, start.y, start.z);
    GuideStrength strength = GuideStrength.STANDARD;
    SegmentDistance wall = new SegmentDistance(wallBelow(), grid(), REACH_MM);
    return List.of(
        Feel.of("none"),
        Feel.of("guide axis", Guides.axis(start, new Vec3(0, 0, -1), strength)),
        Feel.of("guide plane", Guides.plane(start, new Vec3(1, 0, 0), strength)),
        Feel.of("guide sphere", Guides.ball(start, BALL_MM, strength)),
        Feel.of("guide path", Guides.path(bentPath(start), strength)),
        Feel.of("guide hinge", Guides.hinge(aside, new Vec3(0, 1, 0), strength)),
        Feel.of("guide away", Guides.away(wall, REACH_MM, strength)),
        Feel.of("viscosity 0.002", Effects.viscosity(0.002)),
        Feel.of("viscosity 0.01", Effects.viscosity(0.01)),
        Feel.of("magnet 0.04 N", Effects.magnet(wall, 0.04, REACH_MM)),
        Feel.of("stick-slip 0.3 N", Effects.stickSlip(0.3)),
        Feel.ofPlans("texture 0.2 mm", true, false, Effects.texture(ripples(), 0.2)),
        Feel.ofPlans("vibration 100 Hz 0.3 N", true, true, Effects.vibration(100, 0.3)),
        Feel.ofMaterials("tissue from grey", new GreyMaterials(tissue(), GreyMaterials.CT)),
        Feel.ofMass(0.005),
        Feel.ofMass(0.05),
        Feel.ofMass(0.3),
        Feel.ofMass(1));
  }

  private static VoxelGrid grid() {
    RigidTransform axes = RigidTransform.identity();
    Vec3 corner = WALL.touchMm();
    double half = EDGE / 2 * VOXEL;
    axes.origin().set(corner.x - half, corner.y - half, corner.z - half);
    return new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(VOXEL, VOXEL, VOXEL), axes);
  }

  private static BitCube wallBelow() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE / 2; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    return bits;
  }

  /** Returns a path that leads into the wall beside the hand, and then along it. */
  private static List<Vec3> bentPath(Vec3 start) {
    return List.of(
        start,
        new Vec3(start.x + 0.5, start.y, start.z - START_MM),
        new Vec3(start.x + 4, start.y, start.z - START_MM));
  }

  /** Returns Hounsfield units that rise from fat to bone along x, as the hand slides. */
  private static ScalarVolume tissue() {
    ScalarVolume grey = ScalarVolume.of(grid(), ScalarVolume.Storage.INT16);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      grey.set(i, n / EDGE % EDGE, n / (EDGE * EDGE), Math.min(1000, -200 + 100 * Math.abs(i - 8)));
    }
    return grey;
  }

  /** Returns values whose detail is a checkerboard of height 1. */
  private static ScalarVolume ripples() {
    ScalarVolume grey = ScalarVolume.of(grid(), ScalarVolume.Storage.UINT8);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      grey.set(i, j, n / (EDGE * EDGE), (i / 2 + j / 2) % 2);
    }
    return grey;
  }

  @Override
  public List<Object> conditionCells() {
    return List.of(feel.name());
  }

  @Override
  public Outcome run(double newtonPerM) {
    return run(newtonPerM, FramePublisher.NONE);
  }

  @Override
  public double givenMillijoule(double newtonPerM) {
    HandWork work = new HandWork(VOXEL);
    run(newtonPerM, work);
    return work.millijoule();
  }

  @Override
  public boolean isDriven() {
    return feel.driven();
  }

  private Outcome run(double newtonPerM, FramePublisher publisher) {
    ClosedLoop loop = new ClosedLoop(device, grip, sampling, WALL.touchMm(), INWARD);
    Plant plant = loop.plant(VOXEL);
    ForceSettings smooth = ForceSettings.of(newtonPerM * N_PER_MM, 0);
    FrameSettings settings = FrameSettings.live(plant.specification(), smooth);
    PointFrame frame =
        new PointFrame(
            GridDevice.inGridCoordinates(new SettlingDevice(plant, sampling)),
            new GuardedSolver(METRIC, 8 * VOXEL),
            WALL.scene(),
            METRIC,
            settings,
            new EditQueue(VoxelGrid.ofUnitVoxels(1, 1, 1), 1),
            publisher);
    EffectSite site =
        new EffectSite(
            RigidTransform.identity(),
            settings.force().stiffnessNewtonPerMm(),
            0,
            settings.maxForceNewton(),
            List.of(new Vec3()));
    frame.requestEffects(feel.plans().stream().map(plan -> plan.make(site)).toList());
    feel.materials().ifPresent(frame::use);
    if (feel.massKg().isPresent()) {
      MassSettings held = new MassSettings(feel.massKg().getAsDouble(), new Vec3());
      frame.give(new MassiveContact(METRIC, settings.force(), held));
    }
    return loop.run(plant, frame);
  }
}
