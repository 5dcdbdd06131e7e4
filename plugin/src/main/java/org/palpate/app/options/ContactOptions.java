package org.palpate.app.options;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.app.process.PalpateException;
import org.palpate.body.Placement;
import org.palpate.force.EffectPlan;
import org.palpate.force.FeelSettings;
import org.palpate.force.FrictionForm;
import org.palpate.host.BorderChoice;
import org.palpate.host.CollisionChoice;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MaterialOverride;
import org.palpate.host.SolverKind;
import org.palpate.io.scene.SceneBody;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;

/** The options of contact: solver, collision and force. */
public final class ContactOptions {
  private static final NumberRange STIFFNESS =
      new NumberRange(
          "--stiffness",
          "the stiffness",
          MaterialOverride.LEAST_STIFFNESS,
          MaterialOverride.MOST_STIFFNESS,
          "N/mm",
          "0.5");
  private static final NumberRange FRICTION =
      new NumberRange(
          "--friction", "the friction coefficient", 0, MaterialOverride.MOST_FRICTION, "", "0.2");
  private static final NumberRange CARVE =
      NumberRange.positive("--carve", "the rate", "mm^3 per N s");
  private static final NumberRange MAX_STEP =
      NumberRange.positive("--max-step", "the longest path", "mm");
  private static final NumberRange MAX_FORCE =
      NumberRange.positive("--max-force", "the largest force", "N");

  @Option(
      names = "--solver",
      paramLabel = "NAME",
      description = {
        "Solver of the interaction point: smooth (along the surface), guarded (along voxels),"
            + " paper"
            + " or dot (baselines without the guarantee), or none (collision alone).",
        "Default: ${DEFAULT-VALUE}."
      },
      defaultValue = "smooth")
  private String solverName;

  @Option(
      names = "--collision",
      paramLabel = "METHOD",
      description = {
        "Collision method: sampled:STEP, gridplanes or exact, for the solvers none, dot and paper.",
        "Default: exact for none, sampled:1 for dot and paper. The other solvers are always exact."
      })
  private String collision;

  @Option(
      names = "--border",
      paramLabel = "METHOD",
      description = {
        "Border voxels of the solvers dot and paper: on-the-fly (found at each query) or"
            + " precalculated (kept until an edit; faster). The result is the same.",
        "Default: on-the-fly."
      })
  private String border;

  @Option(
      names = "--stiffness",
      paramLabel = "N/MM",
      description =
          "Force for each mm between device and interaction point, 1e-6 to 1e6. Default: 0.5 for"
              + " scenes from 32 mm to 1 m, more for smaller ones, or half of what a real device"
              + " can render.")
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
        "Friction model: equation4 (the paper's), shorter (its shorter form, for"
            + " comparison) or cone (static and sliding). Default: ${DEFAULT-VALUE}. A rigid tool"
            + " always has cones."
      },
      defaultValue = "equation4")
  private String frictionForm;

  /** Options that move or change segments, or move the needle. */
  private static final List<String> NOT_WITH_NEEDLES =
      List.of("--carve", "--brush", "--edits", "--poses", "--scene", "--mass");

  @Option(
      names = "--material",
      paramLabel = "NAME=WHAT",
      description = {
        "Material of one segment, if it differs from the others; may be repeated. WHAT is any of"
            + " stiffness:N/MM, friction:MU, sliding:MU, damping:N*S/MM, cut:N (the force below"
            + " which --carve cuts nothing), and for a needle puncture:N (it may enter), cutting:N"
            + " and shaft:N/MM, separated by commas, as"
            + " in --material bone=stiffness:0.8,friction:0.3 --material"
            + " skin=stiffness:0.2,damping:0.002. If segments share a voxel, the first of them"
            + " counts."
      })
  private Map<String, String> materials = new LinkedHashMap<>();

  @Option(
      names = "--smooth-from",
      paramLabel = "WHAT",
      description = {
        "Source of the surface for the solver smooth: grey (grey values; needs one segment by a"
            + " threshold, NAME=>=VALUE) or bits (its voxels). Default: grey if possible."
      })
  private String smoothFrom;

  @Option(
      names = "--max-step",
      paramLabel = "MM",
      description = {
        "Longest path of the interaction point in one frame.",
        "Default: 8 times the shortest or 3 times the longest voxel edge, whichever is larger."
      })
  private Double maxStep;

  @Option(
      names = "--carve",
      paramLabel = "RATE",
      description = {
        "Cuts: removes the voxels that the tool would overlap on its way to the device, at most"
            + " RATE mm^3 for each N of force and second, the nearest first."
      })
  private Double carve;

  @Option(
      names = "--protect",
      paramLabel = "NAME[:MM[:MM]]",
      description = {
        "A segment that the tool keeps away from by a margin in mm, 0 if none is given, and from"
            + " which and from whose margin nothing is cut; may be repeated. A force pushes the"
            + " tool away as soon as it is nearer to the margin than the second length, which is"
            + " the first one by default."
      })
  private List<String> protectedSegments = List.of();

  @Option(
      names = "--max-force",
      paramLabel = "N",
      description = "Largest force. Default: the device's maximum; in a replay, no limit.")
  private Double maxForce;

  /**
   * Takes materials, margins and the rate of cutting of a scene file, except for what an option
   * gives.
   *
   * @throws VolumeFormatException if the scene cannot be read
   */
  public void takeFrom(VolumeOptions volume, ParseResult given) throws VolumeFormatException {
    if (volume.scene().isEmpty()) {
      return;
    }
    SceneFile scene = SceneReader.read(volume.scene().get());
    for (SceneBody body : scene.bodies()) {
      body.material().ifPresent(text -> materials.putIfAbsent(body.name(), text));
    }
    if (carve == null && scene.carve().isPresent()) {
      carve = scene.carve().getAsDouble();
    }
    if (!given.hasMatchedOption("--protect")) {
      protectedSegments = scene.protect();
    }
  }

  /**
   * Returns the solver.
   *
   * @throws PalpateException exit code 2, if there is no such solver
   */
  public SolverKind solver() {
    return SolverKind.parse(solverName)
        .orElseThrow(
            () ->
                PalpateException.wrongUse(
                    "there is no such solver",
                    "--solver " + solverName,
                    "choose smooth, guarded, paper, dot or none"));
  }

  /**
   * Returns the checked settings.
   *
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public ContactSettings settings() {
    return settings(FeelSettings.NONE);
  }

  private ContactSettings settings(FeelSettings feel) {
    return ContactSettings.builder(solver())
        .feel(feel)
        .collision(collision())
        .stiffness(stiffnessNewtonPerMm())
        .friction(friction())
        .maxStep(maxStepMm())
        .maxForce(maxForceNewton())
        .frictionForm(frictionForm())
        .materials(materials())
        .carve(carveMm3PerNewtonSecond())
        .protect(protectedMm())
        .border(border())
        .build();
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
                                "the material cannot be read",
                                "--material " + name + "=" + text,
                                "write for example "
                                    + name
                                    + "=stiffness:0.8,friction:0.3,damping:0, with a stiffness of"
                                    + " 0 or from 0.000001 to 1,000,000 N/mm, friction from 0 to"
                                    + " 100, sliding at most friction, damping from 0 to"
                                    + " 1,000,000 N s/mm, cut, puncture, cutting and shaft from 0"
                                    + " to 1,000,000, the last two only with puncture"))));
    return choices;
  }

  /**
   * Refuses segments that a needle may enter, unless there is a needle and nothing changes them.
   *
   * @param isNeedle whether the tool is a needle
   * @throws PalpateException exit code 2, if something does not fit
   */
  public void checkNeedle(boolean isNeedle, ParseResult given) {
    Optional<String> name =
        materials().entrySet().stream()
            .filter(entry -> entry.getValue().isPenetrable())
            .map(Map.Entry::getKey)
            .findFirst();
    if (name.isEmpty()) {
      return;
    }
    String option = "--material " + name.get() + "=" + materials.get(name.get());
    if (!isNeedle) {
      throw PalpateException.wrongUse(
          "only a needle enters a segment", option, "add --tool needle:R,L, or leave puncture out");
    }
    for (String other : NOT_WITH_NEEDLES) {
      if (given.hasMatchedOption(other)) {
        throw PalpateException.wrongUse(
            "a needle in tissue has no mass, and tissue neither moves nor changes",
            other + " with " + option,
            "leave one of them out");
      }
    }
    if (settings().protectedMm().containsKey(name.get())) {
      throw PalpateException.wrongUse(
          "what is protected cannot be entered", option, "leave puncture or --protect out");
    }
  }

  private FrictionForm frictionForm() {
    return switch (frictionForm) {
      case "equation4" -> FrictionForm.EQUATION_4;
      case "shorter" -> FrictionForm.SHORTER;
      case "cone" -> FrictionForm.CONE;
      default ->
          throw PalpateException.wrongUse(
              "there is no such friction model",
              "--friction-form " + frictionForm,
              "choose equation4, shorter or cone");
    };
  }

  /**
   * Returns the contact scene of a volume.
   *
   * @param source the volume
   * @param segments its segments
   * @param feel what the hand feels beside plain contact
   * @throws VolumeFormatException if the grey values are needed and cannot be read
   */
  public ContactScene scene(VolumeSource source, SegmentedVolume segments, FeelSettings feel)
      throws VolumeFormatException {
    ContactSettings settings = settings();
    for (String name : materials.keySet()) {
      NamedSegment.of(segments, "--material ", name, name);
    }
    if (!settings.protectedMm().isEmpty()
        && !(segments.hasOneGrid() && source.placements().stream().allMatch(Placement::isAtRest))) {
      throw PalpateException.wrongUse(
          "margins are for bodies of one grid that are fixed where they rest",
          "--protect",
          "leave it out, or make all bodies of the scene fixed, without poses, from one volume");
    }
    List<EffectPlan> all = new ArrayList<>(feel.effects());
    for (Protection each : Protection.all(protectedSegments)) {
      each.guidance(segments).ifPresent(all::add);
    }
    FeelSettings guided = new FeelSettings(all, feel.mass(), feel.materials());
    return new ContactScene(segments, source.placements(), settings(guided), grey(source));
  }

  /**
   * Reads the segments of a volume that will be touched.
   *
   * @param err receives notes, a line each
   * @param keepsGrey whether to keep the grey values even if the solver does not follow them
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public SegmentedVolume segments(VolumeSource source, PrintWriter err, boolean keepsGrey)
      throws VolumeFormatException {
    SegmentedVolume found = source.segments(err, keepsGrey || followsGrey(source));
    solver()
        .warning(source.name(), found.grids())
        .ifPresent(line -> err.println("palpate: " + line));
    err.flush();
    return found;
  }

  /** Whether the solver will follow the grey values of a volume. */
  boolean followsGrey(VolumeSource source) {
    return allowsGrey() && source.threshold().isPresent();
  }

  private boolean allowsGrey() {
    if (smoothFrom != null && !smoothFrom.equals("grey") && !smoothFrom.equals("bits")) {
      throw PalpateException.wrongUse(
          "there is no such source of a surface",
          "--smooth-from " + smoothFrom,
          "choose grey or bits");
    }
    return solver() == SolverKind.SMOOTH && !"bits".equals(smoothFrom);
  }

  private Optional<GreyIsosurface> grey(VolumeSource source) throws VolumeFormatException {
    if (!allowsGrey()) {
      return Optional.empty();
    }
    Optional<GreyIsosurface> found = source.greySurface();
    if ("grey".equals(smoothFrom) && found.isEmpty()) {
      throw PalpateException.wrongUse(
          "a surface of grey values needs exactly one segment, made by a threshold",
          "--smooth-from grey",
          "choose one with --segment NAME=>=VALUE, or leave --smooth-from out");
    }
    return found;
  }

  private OptionalDouble carveMm3PerNewtonSecond() {
    return CARVE.checkGiven(carve);
  }

  private Map<String, Double> protectedMm() {
    Map<String, Double> margins = new LinkedHashMap<>();
    Protection.all(protectedSegments).forEach(found -> margins.put(found.name(), found.marginMm()));
    return margins;
  }

  /** Whether segments are protected. */
  public boolean protects() {
    return !protectedSegments.isEmpty();
  }

  /** Whether segments have materials of their own. */
  boolean hasMaterials() {
    return !materials.isEmpty();
  }

  /** Whether the tool cuts. */
  public boolean cuts() {
    return carve != null;
  }

  private OptionalDouble stiffnessNewtonPerMm() {
    return STIFFNESS.checkGiven(stiffness);
  }

  private double friction() {
    return FRICTION.check(friction);
  }

  private OptionalDouble maxStepMm() {
    return MAX_STEP.checkGiven(maxStep);
  }

  private OptionalDouble maxForceNewton() {
    return MAX_FORCE.checkGiven(maxForce);
  }

  /**
   * Returns the collision method that was given, otherwise the solver's default.
   *
   * @throws PalpateException exit code 2, if the method is wrong or the solver does not allow it
   */
  public CollisionChoice collision() {
    SolverKind solver = solver();
    if (collision == null) {
      return solver.defaultCollision();
    }
    CollisionChoice choice = CollisionChoice.parse(collision).orElseThrow(this::unknownCollision);
    if (!solver.choosesCollision() && !choice.equals(CollisionChoice.EXACT)) {
      throw PalpateException.wrongUse(
          "the solver " + solver + " always uses exact collision",
          "--collision " + collision,
          "leave it out, or choose --solver none, dot or paper");
    }
    return choice;
  }

  private BorderChoice border() {
    if (border == null) {
      return BorderChoice.ON_THE_FLY;
    }
    BorderChoice choice =
        BorderChoice.parse(border)
            .orElseThrow(
                () ->
                    PalpateException.wrongUse(
                        "there is no such method for border voxels",
                        "--border " + border,
                        "choose on-the-fly or precalculated"));
    if (!solver().usesBorderVoxels()) {
      throw PalpateException.wrongUse(
          "the solver " + solver() + " uses no border voxels",
          "--border " + border,
          "leave it out, or choose --solver dot or paper");
    }
    return choice;
  }

  private PalpateException unknownCollision() {
    return PalpateException.wrongUse(
        "there is no such collision method",
        "--collision " + collision,
        "write sampled:STEP (a step from 0.001 to 1,000 voxels), gridplanes or exact");
  }
}
