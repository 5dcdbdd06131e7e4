package org.palpate.app.options;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.palpate.app.process.PalpateException;
import org.palpate.body.Mobility;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticPlan;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.RecordedUpdates;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.host.ReplayRun;
import org.palpate.host.SolverKind;
import org.palpate.io.file.NumberParser;
import org.palpate.io.scene.SceneBody;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneFill;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;

/** The options of elastic segments. */
public final class ElasticOptions {
  /** The names of these options. */
  public static final List<String> NAMES =
      List.of("--elastic", "--fixed", ElasticFill.OPTION, "--lattice", "--contact-radius");

  private static final NumberRange LATTICE =
      NumberRange.positive("--lattice", "the edge of a cell", "mm");

  private static final NumberRange CONTACT_RADIUS =
      NumberRange.positive("--contact-radius", "the radius of a contact", "mm");

  /** Young's modulus of a fill if the user chooses none: that of soft tissue, Pa. */
  private static final double USUAL_FILL_PASCAL = 10e3;

  @Option(
      names = "--elastic",
      paramLabel = "NAME=WHAT",
      description = {
        "Makes a segment elastic; may be repeated. WHAT is young:PA (Young's modulus, 10 to 1e12"
            + " Pa), then if wanted ,poisson:NU (0 to 0.49, default 0.4, the same for all), as in"
            + " --elastic skin=young:20e3,poisson:0.45. All other segments stand still."
      })
  private Map<String, String> elastic = new LinkedHashMap<>();

  @Option(
      names = "--fixed",
      paramLabel = "NAME",
      description = "States that a segment stands still beside elastic ones; may be repeated.")
  private List<String> fixed = List.of();

  @Option(
      names = "--lattice",
      paramLabel = "MM",
      description =
          "Edge of a finite element of elastic segments, rounded to whole voxels. Default: such"
              + " that some 3,000 cover them.")
  private Double latticeMm;

  @Option(
      names = "--contact-radius",
      paramLabel = "MM",
      description =
          "Radius over which the force on an elastic segment is spread, half an edge of an element"
              + " or more. If it is less than two edges, shorter elements follow the contact."
              + " Default: two edges.")
  private Double contactRadiusMm;

  @Option(
      names = ElasticFill.OPTION,
      paramLabel = "NAME=OUTER..INNER",
      description = {
        "Fills the empty space inside segment OUTER, but not the cavities of segment INNER, with"
            + " elastic matter that cannot be touched; may be repeated. Its modulus is 10e3 Pa, or"
            + " that of --elastic NAME=young:PA.",
        "Default for the phantom head: tissue=skin..skull."
      })
  private Map<String, String> fill = new LinkedHashMap<>();

  private boolean fillsHead;

  /** The voxels of the fills of the last volume, by name. */
  private final Map<String, BitCube> fills = new LinkedHashMap<>();

  /** The materials of the elastic bodies and fills of a scene file. */
  private final Map<String, ElasticMaterial> ofScene = new LinkedHashMap<>();

  /** The voxels of the fills of a scene file. */
  private final Map<String, BitCube> fillsOfScene = new LinkedHashMap<>();

  /** Whether a segment is elastic. */
  public boolean isWanted() {
    return !elastic.isEmpty() || !ofScene.isEmpty();
  }

  /**
   * Takes the elastic bodies of a scene file. An option gives one of them another material.
   *
   * @throws VolumeFormatException if the scene cannot be read, or a material is out of range
   */
  private void takeFrom(VolumeOptions volume) throws VolumeFormatException {
    if (volume.scene().isEmpty()) {
      return;
    }
    Path file = volume.scene().get();
    SceneFile scene = SceneReader.read(file);
    for (SceneBody body : scene.bodies()) {
      if (body.mobility() == Mobility.ELASTIC) {
        takeMaterial(file, body.name(), body.youngPa().orElseThrow(), body.poisson());
      }
    }
    for (SceneFill each : scene.fills()) {
      takeMaterial(file, each.name(), each.youngPa(), each.poisson());
      fillsOfScene.put(each.name(), each.voxels(file));
    }
  }

  private void takeMaterial(Path file, String body, double youngPa, OptionalDouble poisson)
      throws VolumeFormatException {
    try {
      double ratio = poisson.orElse(ElasticMaterial.USUAL_POISSON);
      ofScene.put(body, new ElasticMaterial(youngPa, ratio));
    } catch (IllegalArgumentException e) {
      throw new VolumeFormatException(
          e.getMessage(), file + ": body " + body, "correct young_pa or poisson", e);
    }
  }

  /**
   * Returns a replay with the elastic segments that were asked for, if any.
   *
   * @param solver moves the interaction point
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public ReplayRun deform(ReplayRun replay, SegmentedVolume volume, SolverKind solver) {
    return bodies(volume, solver).map(replay::withElastic).orElse(replay);
  }

  /**
   * Returns a replay with elastic segments that are updated as in a recorded session.
   *
   * @param solver moves the interaction point
   * @param fields the file with the updates, for messages
   * @throws PalpateException exit code 2, if an option is wrong or the updates are those of another
   *     lattice
   */
  public ReplayRun deform(
      ReplayRun replay,
      SegmentedVolume volume,
      SolverKind solver,
      Path fields,
      List<RecordedUpdate> recorded) {
    Supplier<ElasticBody> bodies =
        bodies(volume, solver)
            .orElseThrow(
                () ->
                    PalpateException.wrongUse(
                        "no segment is elastic",
                        "--fields " + fields,
                        "add --elastic NAME=young:PA, or leave it out"));
    try {
      new RecordedUpdates(bodies.get(), recorded); // So that a wrong cell is found at once.
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(
          e.getMessage(),
          fields.toString(),
          "give the scene, --lattice and --contact-radius of the session that recorded it",
          e);
    }
    return replay.withElastic(bodies, recorded);
  }

  /**
   * Takes the elastic bodies of a scene, and refuses what does not go with elastic segments: a
   * rigid tool, a mass, and poses.
   *
   * @throws VolumeFormatException if the scene cannot be read, or a material in it is out of range
   * @throws PalpateException exit code 2, if segments are elastic and one of these is wanted, or
   *     the edge of a cell is out of range
   */
  public void check(VolumeOptions volume, ToolOptions tool) throws VolumeFormatException {
    LATTICE.checkGiven(latticeMm);
    CONTACT_RADIUS.checkGiven(contactRadiusMm);
    fillsHead = volume.isHeadPhantom();
    takeFrom(volume);
    if (!ofScene.isEmpty() && tool.isRigid()) {
      throw PalpateException.wrongUse(
          "a rigid tool touches no elastic body",
          "--scene " + volume.scene().orElseThrow(),
          "write the tool point, or the mobility fixed");
    }
    if (isWanted() && tool.massKg().isPresent()) {
      throw PalpateException.wrongUse(
          "a point with mass touches rigid segments alone",
          "--elastic with --mass",
          "leave one of them out");
    }
    if (isWanted() && volume.isPlaced()) {
      throw PalpateException.wrongUse(
          "elastic segments are those of one volume", "--elastic", "give a volume, not a scene");
    }
  }

  /**
   * Returns what makes bodies of the elastic segments at rest, if any were asked for. One body is
   * made at once, so that whatever is wrong is found.
   *
   * @param solver moves the interaction point
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public Optional<Supplier<ElasticBody>> bodies(SegmentedVolume volume, SolverKind solver) {
    if (!isWanted()) {
      refuseAlone("--fixed", !fixed.isEmpty());
      refuseAlone("--lattice", latticeMm != null);
      refuseAlone("--contact-radius", contactRadiusMm != null);
      refuseAlone(ElasticFill.OPTION, !fill.isEmpty());
      return Optional.empty();
    }
    if (!solver.keepsGuarantee()) {
      throw PalpateException.wrongUse(
          "elastic segments need a solver that keeps the guarantee",
          "--solver " + solver,
          "choose smooth or guarded");
    }
    for (String name : fixed) {
      checkNamed(volume, "--fixed", name);
      if (elastic.containsKey(name) || ofScene.containsKey(name)) {
        throw PalpateException.wrongUse(
            "a segment is elastic and fixed", "--fixed " + name, "leave one of them out");
      }
    }
    findFills(volume);
    ElasticBody first = newBody(volume);
    ElasticBody[] made = {first};
    return Optional.of(
        () -> {
          ElasticBody body = made[0] == null ? newBody(volume) : made[0];
          made[0] = null;
          return body;
        });
  }

  private static void refuseAlone(String option, boolean given) {
    if (given) {
      throw PalpateException.wrongUse(
          "no segment is elastic", option, "add --elastic NAME=young:PA, or leave it out");
    }
  }

  private static void checkNamed(SegmentedVolume volume, String option, String name) {
    NamedSegment.of(volume, option + " ", name, name);
  }

  private void findFills(SegmentedVolume volume) {
    fills.clear();
    fills.putAll(fillsOfScene);
    if (fill.isEmpty() && fillsHead && ElasticFill.OF_HEAD.fits(volume)) {
      fills.put(ElasticFill.OF_HEAD.name(), ElasticFill.OF_HEAD.voxels(volume));
    }
    fill.forEach(
        (name, between) -> fills.put(name, ElasticFill.parse(name, between).voxels(volume)));
  }

  /** Returns the materials by the names of segments and fills. */
  private Map<String, ElasticMaterial> materials(SegmentedVolume volume) {
    Map<String, ElasticMaterial> materials = new LinkedHashMap<>(ofScene);
    elastic.forEach(
        (name, text) -> {
          if (!fills.containsKey(name)) {
            checkNamed(volume, "--elastic", name);
          }
          materials.put(name, material(name, text));
        });
    double poisson = materials.values().iterator().next().poisson();
    fills
        .keySet()
        .forEach(
            each ->
                materials.computeIfAbsent(
                    each, name -> new ElasticMaterial(USUAL_FILL_PASCAL, poisson)));
    return materials;
  }

  /**
   * Returns the elasticity of a volume for a scene file; without any material if nothing is
   * elastic. Call it after {@link #bodies}.
   */
  public SceneElasticity elasticity(SegmentedVolume volume) {
    return isWanted() ? new SceneElasticity(materials(volume), fills) : SceneElasticity.NONE;
  }

  private ElasticBody newBody(SegmentedVolume volume) {
    Map<String, ElasticMaterial> materials = materials(volume);
    List<ElasticSegment> soft = new ArrayList<>();
    fills.forEach(
        (name, voxels) -> soft.add(new ElasticSegment(voxels, materials.get(name), false)));
    try {
      OptionalDouble edgeMm = LATTICE.checkGiven(latticeMm);
      OptionalDouble radiusMm = CONTACT_RADIUS.checkGiven(contactRadiusMm);
      return ElasticPlan.of(volume, materials, soft, edgeMm).withContact(radiusMm).get();
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(
          e.getMessage(),
          String.join(", ", materials.keySet()),
          contactRadiusMm == null
              ? "change --elastic or --lattice"
              : "change --elastic, --lattice or --contact-radius",
          e);
    }
  }

  private static ElasticMaterial material(String name, String text) {
    return ElasticMaterial.parse(text, NumberParser::number)
        .orElseThrow(
            () ->
                PalpateException.wrongUse(
                    "the elastic material cannot be read",
                    "--elastic " + name + "=" + text,
                    "write for example "
                        + name
                        + "=young:20e3,poisson:0.4, with a modulus of 10 to 1e12 Pa and a ratio of"
                        + " 0 to 0.49"));
  }
}
