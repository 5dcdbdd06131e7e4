package org.palpate.app.options;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.app.process.PalpateException;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.IntBox;
import org.palpate.host.ReplayRun;
import org.palpate.host.SolverKind;
import org.palpate.io.file.NumberParser;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;

/** The options of elastic segments. */
public final class ElasticOptions {
  private static final NumberRange LATTICE =
      NumberRange.positive("--lattice", "the edge of a cell", "mm");

  /** The number of cells over the elastic segments if the user chooses no edge. */
  private static final double USUAL_CELLS = 3000;

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

  /** Whether a segment is elastic. */
  public boolean isWanted() {
    return !elastic.isEmpty();
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
    int cells = bodies.get().hexahedra();
    for (RecordedUpdate update : recorded) {
      for (RecordedUpdate.Refill refill : update.refills()) {
        if (refill.cell() >= cells) {
          throw PalpateException.wrongUse(
              "there is no cell " + refill.cell() + " among " + cells,
              fields.toString(),
              "give the scene and --lattice of the session that recorded it");
        }
      }
    }
    return replay.withElastic(bodies, recorded);
  }

  /**
   * Refuses what does not go with elastic segments: a window, which would not show how they give
   * way, a mass, and poses.
   *
   * @throws PalpateException exit code 2, if segments are elastic and one of these is wanted, or
   *     the edge of a cell is out of range
   */
  public void check(VolumeOptions volume, ToolOptions tool, boolean hasWindow) {
    LATTICE.checkGiven(latticeMm);
    if (isWanted() && hasWindow) {
      throw PalpateException.wrongUse(
          "elastic segments are not drawn yet", "--elastic", "add --headless");
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
    if (elastic.isEmpty()) {
      refuseAlone("--fixed", !fixed.isEmpty());
      refuseAlone("--lattice", latticeMm != null);
      return Optional.empty();
    }
    if (solver != SolverKind.SMOOTH && solver != SolverKind.GUARDED) {
      throw PalpateException.wrongUse(
          "elastic segments need a solver that keeps the guarantee",
          "--solver " + solver,
          "choose smooth or guarded");
    }
    for (String name : fixed) {
      checkNamed(volume, "--fixed", name);
      if (elastic.containsKey(name)) {
        throw PalpateException.wrongUse(
            "a segment is elastic and fixed", "--fixed " + name, "leave one of them out");
      }
    }
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
    if (volume.segments().stream().noneMatch(segment -> segment.name().equals(name))) {
      throw PalpateException.wrongUse(
          "there is no such segment", option + " " + name, "list them with palpate info");
    }
  }

  private ElasticBody newBody(SegmentedVolume volume) {
    Map<String, ElasticMaterial> materials = new LinkedHashMap<>();
    elastic.forEach(
        (name, text) -> {
          checkNamed(volume, "--elastic", name);
          materials.put(name, material(name, text));
        });
    List<ElasticSegment> soft = new ArrayList<>();
    List<BitCube> still = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      ElasticMaterial material = materials.get(segment.name());
      if (material == null) {
        still.add(segment.bits());
      } else {
        soft.add(new ElasticSegment(segment.bits(), material));
      }
    }
    double edgeMm = latticeMm == null ? usualEdgeMm(volume, soft) : latticeMm;
    try {
      ControlLattice lattice = new ControlLattice(volume.grid().metric(), soft, still, edgeMm);
      return new ElasticBody(lattice, volume.grid().metric());
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(
          e.getMessage(),
          String.join(", ", materials.keySet()),
          "change --elastic or --lattice",
          e);
    }
  }

  private static ElasticMaterial material(String name, String text) {
    String[] parts = text.split(",", -1);
    boolean known =
        parts[0].startsWith("young:")
            && (parts.length == 1 || (parts.length == 2 && parts[1].startsWith("poisson:")));
    double young = known ? number(parts[0]) : Double.NaN;
    double poisson =
        !known ? Double.NaN : parts.length == 1 ? ElasticMaterial.USUAL_POISSON : number(parts[1]);
    try {
      return new ElasticMaterial(young, poisson);
    } catch (IllegalArgumentException e) {
      throw PalpateException.wrongUse(
          "the elastic material cannot be read",
          "--elastic " + name + "=" + text,
          "write for example "
              + name
              + "=young:20e3,poisson:0.4, with a modulus of 10 to 1e12 Pa and a ratio of 0 to 0.49",
          e);
    }
  }

  private static double number(String part) {
    return NumberParser.number(part.substring(part.indexOf(':') + 1));
  }

  /** Returns the edge with which the usual number of cells covers the boxes of the segments. */
  private static double usualEdgeMm(SegmentedVolume volume, List<ElasticSegment> soft) {
    double mm3 = 0;
    for (ElasticSegment segment : soft) {
      IntBox box = segment.bits().bounds();
      if (!box.isEmpty()) {
        double voxels = (double) (box.highX - box.lowX + 1) * (box.highY - box.lowY + 1);
        mm3 += voxels * (box.highZ - box.lowZ + 1);
      }
    }
    mm3 *= volume.grid().spacingMm().x * volume.grid().spacingMm().y * volume.grid().spacingMm().z;
    return Math.max(volume.grid().metric().shortestEdgeMm(), Math.cbrt(mm3 / USUAL_CELLS));
  }
}
