package org.palpate.app.options;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.app.process.PalpateException;
import org.palpate.force.FrictionForm;
import org.palpate.host.CollisionChoice;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;

/** The options that say how it feels: solver, collision, force. */
public final class ContactOptions {

  @Option(
      names = "--solver",
      paramLabel = "NAME",
      description = {
        "What moves the interaction point: smooth (along the surface), guarded (along voxels), paper",
        "or dot (to compare with, without the guarantee), or none (collision alone).",
        "Default: ${DEFAULT-VALUE}."
      },
      defaultValue = "smooth")
  private String solverName;

  @Option(
      names = "--collision",
      paramLabel = "METHOD",
      description = {
        "sampled:STEP, gridplanes or exact, for the solvers none, dot and paper.",
        "Default: exact for none, sampled:1 for dot and paper; the others are always exact."
      })
  private String collision;

  @Option(
      names = "--stiffness",
      paramLabel = "N/MM",
      description = "Force for each mm that the device is ahead. Default: 0.5.")
  private Double stiffness;

  @Option(
      names = "--friction",
      paramLabel = "MU",
      description = "Friction coefficient. Default: ${DEFAULT-VALUE}.",
      defaultValue = "0.2")
  private double friction;

  @Option(
      names = "--friction-form",
      paramLabel = "FORM",
      description = {
        "How friction is computed: equation4 (the paper's), shorter (its shorter form, for",
        "comparison) or cone (static and sliding). Default: ${DEFAULT-VALUE}."
      },
      defaultValue = "equation4")
  private String frictionForm;

  @Option(
      names = "--material",
      paramLabel = "NAME=WHAT",
      description = {
        "What a segment feels like where it differs from the rest; may be given again. WHAT is any",
        "of stiffness:N/MM, friction:MU, sliding:MU and damping:N*S/MM with commas between, as in",
        "--material bone=stiffness:0.8,friction:0.3 --material skin=stiffness:0.2,damping:0.002.",
        "Where segments share a voxel the first of them is felt."
      })
  private Map<String, String> materials = new LinkedHashMap<>();

  @Option(
      names = "--smooth-from",
      paramLabel = "WHAT",
      description = {
        "What the solver smooth makes its surface of: grey values, where the one segment is a",
        "threshold (NAME=>=VALUE), or bits. Default: grey where it can."
      })
  private String smoothFrom;

  @Option(
      names = "--max-step",
      paramLabel = "MM",
      description = {
        "The most that the interaction point travels in a frame.",
        "Default: the larger of 8 shortest and 3 longest voxel edges."
      })
  private Double maxStep;

  @Option(names = "--max-force", paramLabel = "N", description = "The largest force ever sent.")
  private Double maxForce;

  /** What moves the interaction point. */
  public SolverKind solver() {
    return SolverKind.parse(solverName)
        .orElseThrow(
            () ->
                PalpateException.wrongUse(
                    "no such solver",
                    "--solver " + solverName,
                    "choose smooth, guarded, paper, dot or none"));
  }

  /** All of them together, checked. */
  public ContactSettings settings() {
    return new ContactSettings(
        solver(),
        collision(),
        stiffnessNewtonPerMm(),
        friction(),
        maxStepMm(),
        maxForceNewton(),
        frictionForm(),
        materials());
  }

  private Map<String, MaterialOverride> materials() {
    Map<String, MaterialOverride> choices = new LinkedHashMap<>();
    materials.forEach(
        (name, text) ->
            choices.put(
                name,
                MaterialOverride.parse(text)
                    .orElseThrow(
                        () ->
                            PalpateException.wrongUse(
                                "not a material",
                                "--material " + name + "=" + text,
                                "write it as in "
                                    + name
                                    + "=stiffness:0.8,friction:0.3,damping:0"
                                    + ", numbers from 0 up, sliding at most friction"))));
    return choices;
  }

  private FrictionForm frictionForm() {
    return switch (frictionForm) {
      case "equation4" -> FrictionForm.EQUATION_4;
      case "shorter" -> FrictionForm.SHORTER;
      case "cone" -> FrictionForm.CONE;
      default ->
          throw PalpateException.wrongUse(
              "no such form of friction",
              "--friction-form " + frictionForm,
              "choose equation4, shorter or cone");
    };
  }

  /**
   * What can be touched, of a source.
   *
   * @param segments that were read from it
   * @throws VolumeFormatException where its grey values are needed and cannot be read
   */
  public ContactScene scene(VolumeSource source, SegmentedVolume segments)
      throws VolumeFormatException {
    for (String name : materials.keySet()) {
      checkNamed(segments, name);
    }
    return new ContactScene(segments, settings(), grey(source));
  }

  private static void checkNamed(SegmentedVolume segments, String name) {
    if (segments.segments().stream().noneMatch(segment -> segment.name().equals(name))) {
      throw PalpateException.wrongUse(
          "there is no such segment", "--material " + name, "see palpate info");
    }
  }

  private Optional<GreyIsosurface> grey(VolumeSource source) throws VolumeFormatException {
    boolean grey = "grey".equals(smoothFrom);
    if (smoothFrom != null && !grey && !smoothFrom.equals("bits")) {
      throw PalpateException.wrongUse(
          "no such source of a surface", "--smooth-from " + smoothFrom, "choose grey or bits");
    }
    if (solver() != SolverKind.SMOOTH || (smoothFrom != null && !grey)) {
      return Optional.empty();
    }
    Optional<GreyIsosurface> found = source.greySurface();
    if (grey && found.isEmpty()) {
      throw PalpateException.wrongUse(
          "a surface of grey values needs one segment made by a threshold",
          "--smooth-from grey",
          "choose one with --segment NAME=>=VALUE, or leave --smooth-from out");
    }
    return found;
  }

  /** Force over distance, N/mm of scan, where it was given. */
  public OptionalDouble stiffnessNewtonPerMm() {
    return positive("--stiffness", stiffness);
  }

  /** The friction coefficient, 0 or more. */
  public double friction() {
    if (!(friction >= 0) || Double.isInfinite(friction)) {
      throw PalpateException.wrongUse(
          "friction must be a number from 0 up", "--friction " + friction, "try --friction 0.2");
    }
    return friction;
  }

  /** w_max in mm, where it was given. */
  public OptionalDouble maxStepMm() {
    return positive("--max-step", maxStep);
  }

  /** The largest force, N, where it was given. */
  public OptionalDouble maxForceNewton() {
    return positive("--max-force", maxForce);
  }

  private static OptionalDouble positive(String option, Double value) {
    if (value == null) {
      return OptionalDouble.empty();
    }
    if (!(value > 0) || value.isInfinite()) {
      throw PalpateException.wrongUse(
          "a positive number is needed", option + " " + value, "try " + option + " 1");
    }
    return OptionalDouble.of(value);
  }

  /** How collisions are found: the method that was given, else the solver's own. */
  public CollisionChoice collision() {
    SolverKind solver = solver();
    if (collision == null) {
      return solver.defaultCollision();
    }
    CollisionChoice choice = CollisionChoice.parse(collision).orElseThrow(this::notACollision);
    if (!solver.choosesCollision() && !choice.equals(CollisionChoice.EXACT)) {
      throw PalpateException.wrongUse(
          "the solver " + solver + " is always exact",
          "--collision " + collision,
          "leave it out, or choose --solver none, dot or paper");
    }
    return choice;
  }

  private PalpateException notACollision() {
    return PalpateException.wrongUse(
        "not a way to find collisions",
        "--collision " + collision,
        "write sampled:STEP with a positive step in voxels, gridplanes or exact");
  }
}
