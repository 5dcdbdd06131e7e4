package org.palpate.benchmarks.stability;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.palpate.benchmarks.stability.Trial.SolverChoice;
import org.palpate.force.EffectPlan;
import org.palpate.force.effect.Effects;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.exact.GuardedSolver;

/**
 * The sweeps of the study. Each returns rows and sends progress lines to a listener.
 *
 * <p>The default stiffness of a device is half its maximum, scaled by the workspace. The scale
 * cancels at the handle, so the model needs none.
 */
public final class StabilityStudy {
  /** The guarded solver, used for devices and for the theory. */
  public static final SolverChoice GUARDED = new SolverChoice("guarded", GuardedSolver::new);

  private static final Sampling DEFAULT_SAMPLING = new Sampling(1000, 1);

  /** The length of the rods that have mass, a guide or an effect. */
  private static final double ROD_MM = 20;

  private final boolean quick;
  private final List<SolverChoice> solvers;
  private final Consumer<String> progress;
  private final TouchedShape wall = TouchedShape.wall();

  /**
   * Creates a study.
   *
   * @param quick whether to use fewer values in each sweep
   * @param solvers the solvers that are compared on shapes
   * @param progress receives progress lines
   */
  public StabilityStudy(boolean quick, List<SolverChoice> solvers, Consumer<String> progress) {
    this.quick = quick;
    this.solvers = List.copyOf(solvers);
    this.progress = progress;
  }

  /**
   * The model against the theory: a handle without a hand, on a flat wall.
   *
   * @param sampling rate and delay
   * @param damping the physical damping b, N s/m
   * @param largest the largest stable stiffness, N/m
   * @param passive the bound of the theory, N/m
   */
  public record TheoryRow(Sampling sampling, double damping, double largest, double passive) {
    /** Returns the cells of its row in {@code stability-theory.csv}. */
    List<Object> cells() {
      return List.of(sampling.rateHz(), sampling.delaySamples(), damping, largest, passive);
    }
  }

  /** Sweeps rate, delay and physical damping. */
  public List<TheoryRow> theory() {
    double[] rates =
        quick ? new double[] {1000, 4000} : new double[] {500, 1000, 2000, 4000, 10_000, 20_000};
    double[] dampings = quick ? new double[] {2} : new double[] {0.5, 2, 8};
    DeviceModel bare = new DeviceModel("bare", 1000, 1, 0.1, 1, 1).withFineEncoder();
    List<TheoryRow> rows = new ArrayList<>();
    for (double damping : dampings) {
      for (int delay = 0; delay <= 2; delay++) {
        for (double rate : rates) {
          Sampling sampling = new Sampling(rate, delay);
          progress.accept("theory: b=" + damping + " delay=" + delay + " rate=" + rate);
          Trial trial =
              new Trial(bare.withDamping(damping), Grip.NONE, sampling, wall, GUARDED, false);
          rows.add(
              new TheoryRow(
                  sampling,
                  damping,
                  StiffnessSearch.largest(trial::run),
                  sampling.passiveNewtonPerM(damping)));
        }
      }
    }
    return rows;
  }

  /** Sweeps devices by name, mass, damping, grip and delay at 1 kHz, and the rate above it. */
  public List<MarginRow<Trial>> devices() {
    List<Trial> trials = new ArrayList<>(deviceTrials());
    trials.addAll(fastTrials());
    List<MarginRow<Trial>> rows = new ArrayList<>();
    for (Trial trial : trials) {
      progress.accept(
          "devices: "
              + trial.device().name()
              + " grip="
              + trial.grip().name()
              + " rate="
              + trial.sampling().rateHz()
              + " delay="
              + trial.sampling().delaySamples());
      rows.add(MarginRow.of(trial));
    }
    return rows;
  }

  /** Returns set-ups above 1 kHz with the assumed mass and damping, one frame of delay. */
  private List<Trial> fastTrials() {
    List<Trial> trials = new ArrayList<>();
    for (double rateHz : quick ? new double[] {10_000} : new double[] {5_000, 10_000}) {
      for (DeviceModel device : DeviceModel.KNOWN) {
        for (Grip grip : quick ? List.of(Grip.LIGHT) : List.of(Grip.LIGHT, Grip.FIRM)) {
          trials.add(new Trial(device, grip, new Sampling(rateHz, 1), wall, GUARDED, true));
        }
      }
    }
    return trials;
  }

  /** Returns the set-ups of {@link #devices} at 1 kHz. */
  List<Trial> deviceTrials() {
    double[] massFactors = quick ? new double[] {0.5, 2} : new double[] {0.5, 1, 2};
    double[] dampingFactors = quick ? new double[] {0.25, 1} : new double[] {0.25, 1, 4};
    List<Trial> trials = new ArrayList<>();
    for (DeviceModel device : DeviceModel.KNOWN) {
      for (Grip grip : List.of(Grip.LIGHT, Grip.FIRM)) {
        for (int delay = 1; delay <= 2; delay++) {
          for (DeviceModel varied : varied(device, massFactors, dampingFactors)) {
            Sampling sampling = new Sampling(DEFAULT_SAMPLING.rateHz(), delay);
            trials.add(new Trial(varied, grip, sampling, wall, GUARDED, true));
          }
        }
      }
    }
    return trials;
  }

  /** Sweeps the length of a rod, and devices by name, mass, damping, grip and delay. */
  List<MarginRow<HeldTrial>> tools() {
    double[] lengthsMm = quick ? new double[] {0, 60} : new double[] {0, 20, 60, 120};
    double[] massFactors = quick ? new double[] {2} : new double[] {0.5, 1, 2};
    double[] dampingFactors = quick ? new double[] {0.25} : new double[] {0.25, 1, 4};
    List<MarginRow<HeldTrial>> rows = new ArrayList<>();
    for (DeviceModel device : DeviceModel.KNOWN) {
      for (double lengthMm : lengthsMm) {
        progress.accept("tools: " + device.name() + " rod=" + lengthMm + " mm");
        for (Grip grip : quick ? List.of(Grip.LIGHT) : List.of(Grip.LIGHT, Grip.FIRM)) {
          for (int delay = quick ? 2 : 1; delay <= 2; delay++) {
            Sampling sampling = new Sampling(DEFAULT_SAMPLING.rateHz(), delay);
            for (DeviceModel varied : varied(device, massFactors, dampingFactors)) {
              HeldTool rod = HeldRod.of(lengthMm);
              rows.add(MarginRow.of(new ToolTrial(varied, grip, sampling, rod)));
            }
          }
        }
      }
    }
    return rows;
  }

  /** Sweeps needles, rods with mass and rods with effects: devices by name, grips and rates. */
  List<MarginRow<HeldTrial>> heldTools() {
    List<MarginRow<HeldTrial>> rows = new ArrayList<>();
    for (Sampling sampling : feelSamplings()) {
      for (HeldTool tool : sampling.equals(DEFAULT_SAMPLING) ? heldToolKinds() : fastToolKinds()) {
        for (DeviceModel device : feelDevices()) {
          progress.accept(
              "tools: " + device.name() + " " + tool.name() + " rate=" + sampling.rateHz());
          for (Grip grip : feelGrips()) {
            rows.add(MarginRow.of(new ToolTrial(device, grip, sampling, tool)));
          }
        }
      }
    }
    return rows;
  }

  /**
   * Sweeps a fragment in hand with and without the guide {@code fit}: devices by name and grips.
   */
  List<MarginRow<HeldTrial>> fragments() {
    List<MarginRow<HeldTrial>> rows = new ArrayList<>();
    for (boolean guided : new boolean[] {false, true}) {
      for (DeviceModel device : feelDevices()) {
        for (Grip grip : feelGrips()) {
          FragmentTrial trial = new FragmentTrial(device, grip, DEFAULT_SAMPLING, guided);
          progress.accept(
              "tools: " + device.name() + " " + trial.heldName() + " grip=" + grip.name());
          rows.add(MarginRow.of(trial));
        }
      }
    }
    return rows;
  }

  /** Returns a needle, and rods of one length with mass, a guide or an effect. */
  private static List<HeldTool> heldToolKinds() {
    EffectPlan align = Guides.align(new Vec3(1, 0, 0), GuideStrength.STANDARD);
    List<HeldTool> tools = new ArrayList<>(fastToolKinds());
    tools.add(HeldRod.of(ROD_MM, "guide align", align));
    tools.add(HeldRod.of(ROD_MM, "viscosity 0.002", Effects.viscosity(0.002)));
    return tools;
  }

  /** Returns the tools that are also studied above 1 kHz. */
  private static List<HeldTool> fastToolKinds() {
    return List.of(new HeldNeedle(), HeldRod.of(ROD_MM, 0.05), HeldRod.of(ROD_MM, 0.3));
  }

  /** Sweeps guides, effects and masses: devices by name, both grips and rates. */
  public List<MarginRow<FeelTrial>> feel() {
    List<MarginRow<FeelTrial>> rows = new ArrayList<>();
    for (Sampling sampling : feelSamplings()) {
      for (DeviceModel device : feelDevices()) {
        for (Grip grip : feelGrips()) {
          progress.accept(
              "feel: " + device.name() + " grip=" + grip.name() + " rate=" + sampling.rateHz());
          for (FeelTrial.Feel feel : FeelTrial.feels()) {
            if (sampling.equals(DEFAULT_SAMPLING) || feel.isStudiedFast()) {
              rows.add(MarginRow.of(new FeelTrial(device, grip, sampling, feel)));
            }
          }
        }
      }
    }
    return rows;
  }

  /** Returns the rates at which needles, mass, guides and effects are studied. */
  private List<Sampling> feelSamplings() {
    return quick
        ? List.of(DEFAULT_SAMPLING)
        : List.of(DEFAULT_SAMPLING, new Sampling(5_000, 1), new Sampling(10_000, 1));
  }

  private List<DeviceModel> feelDevices() {
    return quick ? DeviceModel.KNOWN.subList(0, 2) : DeviceModel.KNOWN;
  }

  private List<Grip> feelGrips() {
    return quick ? List.of(Grip.LIGHT) : List.of(Grip.LIGHT, Grip.FIRM);
  }

  /** Sweeps the rate of a burr that cuts and the stiffness, with devices by name and both grips. */
  public List<CarveTrial.Result> carving() {
    double[] rates = quick ? new double[] {40} : new double[] {40, 400};
    double[] overDefaults = quick ? new double[] {1} : new double[] {1, 2};
    List<CarveTrial.Result> results = new ArrayList<>();
    for (DeviceModel device : DeviceModel.KNOWN) {
      for (Grip grip : quick ? List.of(Grip.LIGHT) : List.of(Grip.LIGHT, Grip.FIRM)) {
        progress.accept("carving: " + device.name() + " grip=" + grip.name());
        for (double rate : rates) {
          for (double overDefault : overDefaults) {
            results.add(new CarveTrial(device, grip, DEFAULT_SAMPLING, rate).run(overDefault));
          }
        }
      }
    }
    return results;
  }

  private static List<DeviceModel> varied(
      DeviceModel device, double[] massFactors, double[] dampingFactors) {
    List<DeviceModel> all = new ArrayList<>();
    for (double massFactor : massFactors) {
      for (double dampingFactor : dampingFactors) {
        all.add(
            device
                .withHandleKg(device.handleKg() * massFactor)
                .withDamping(device.dampingNewtonSecondPerM() * dampingFactor));
      }
    }
    return all;
  }

  /** Sweeps shapes and solvers with the softest and the stiffest kind of device, firmly gripped. */
  public List<MarginRow<Trial>> shapes() {
    List<DeviceModel> devices =
        DeviceModel.KNOWN.stream()
            .filter(device -> List.of("Touch", "omega").contains(device.name()))
            .toList();
    List<MarginRow<Trial>> rows = new ArrayList<>();
    for (TouchedShape shape : TouchedShape.all()) {
      for (SolverChoice solver : solvers) {
        for (DeviceModel device : devices) {
          progress.accept(
              "shapes: " + shape.name() + " by " + solver.name() + " with " + device.name());
          rows.add(
              MarginRow.of(new Trial(device, Grip.FIRM, DEFAULT_SAMPLING, shape, solver, true)));
        }
      }
    }
    return rows;
  }

  /** Returns the least margin of each device, in the order of the devices. */
  public static Map<String, Double> leastMargins(List<MarginRow<Trial>> rows) {
    Map<String, Double> least = new LinkedHashMap<>();
    for (MarginRow<Trial> row : rows) {
      least.merge(row.trial().device().name(), row.margin(), Math::min);
    }
    return least;
  }
}
