package org.palpate.app.options;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.palpate.app.process.PalpateException;
import org.palpate.force.EffectPlan;
import org.palpate.force.FeelSettings;
import org.palpate.force.MassSettings;
import org.palpate.force.guide.FitExchange;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.force.guide.PathShape;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.NumbersCsvReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of what the hand feels beside plain contact: guides, effects, grey values. */
public final class FeelOptions {
  private static final NumberRange STRENGTH =
      new NumberRange(
          "--guide-stiffness", "the stiffness of guides", NumberRange.LEAST, 1e6, "N/mm", "0.2");
  private static final NumberRange PULL =
      new NumberRange("--guide-force", "the largest pull", NumberRange.LEAST, 1e6, "N", "2");
  private static final NumberRange RANGE =
      NumberRange.positive("--guide-range", "the range of guides", "mm");
  private static final double MOST_MM = 1e6;

  @Option(
      names = "--guide",
      paramLabel = "KIND:WHERE",
      description = {
        "Guides the hand with a force; may be repeated. In world mm: axis:X,Y,Z,DX,DY,DZ (on a"
            + " line), plane:X,Y,Z,NX,NY,NZ (in a plane), sphere:X,Y,Z,R (in a ball),"
            + " hinge:X,Y,Z,DX,DY,DZ (turns about a line), path:FILE.csv (along positions x,y,z),"
            + " away:NAME,MM (out of a margin around a segment), align:DX,DY,DZ (the axis z of a"
            + " rigid tool along a direction), fit[:GAP] (a fragment in hand to where its fracture"
            + " faces fit; touch alone; GAP is the width of a saw cut in mm, or free to let the fit"
            + " find it. Default: 0)."
      })
  private List<String> guides = List.of();

  @Option(
      names = "--guide-stiffness",
      paramLabel = "N/MM",
      description = "Pull of guides for each mm. Default: half the stiffness of contact.")
  private Double guideStiffness;

  @Option(
      names = "--guide-force",
      paramLabel = "N",
      description = "Largest pull of each guide. Default: 2.")
  private Double guideForce;

  @Option(
      names = "--guide-range",
      paramLabel = "MM",
      description =
          "Distance beyond which guides do not pull; from half of it on they fade. Default: none.")
  private Double guideRange;

  private final FitExchange fits = new FitExchange();

  @Mixin private EffectOptions effects;
  @Mixin private GreyMaterialOptions materials;
  @Mixin private FitGreyOption fitGrey;

  /**
   * Checks the numbers and the forms, before a volume is read.
   *
   * @param isRigid whether the hand holds a rigid tool
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public void check(boolean isRigid, ContactOptions contact) {
    effects.check();
    materials.check(contact);
    fitGrey.check(fit().isPresent());
    GuideStrength strength = strength();
    for (String text : guides) {
      String kind = EffectOptions.kind(text);
      if (kind.equals("away")) {
        marginMm(text);
      } else if (kind.equals("path")) {
        file(text);
      } else if (kind.equals("fit")) {
        gapMm(text);
      } else {
        plan(text, kind, strength);
      }
      if (kind.equals("align") && !isRigid) {
        throw PalpateException.wrongUse(
            "a point has no direction", "--guide " + text, "choose a rigid tool with --tool");
      }
    }
  }

  /**
   * Checks that a guide to a fit has something to fit.
   *
   * @param canHold whether the hand can take hold of fragments
   * @throws PalpateException exit code 2, if not
   */
  public void checkFit(boolean canHold) {
    if (!canHold && fit().isPresent()) {
      throw PalpateException.wrongUse(
          "nobody holds a fragment that could fit",
          "--guide " + fit().get(),
          "choose palpate touch with --scene FILE.json or --phantom fracture, or leave it out");
    }
  }

  private Optional<String> fit() {
    List<String> found =
        guides.stream().filter(text -> EffectOptions.kind(text).equals("fit")).toList();
    if (found.size() > 1) {
      throw PalpateException.wrongUse(
          "there is more than one guide to a fit", "--guide " + found.get(1), "leave one out");
    }
    return found.stream().findFirst();
  }

  /**
   * Returns what finds the fits of the fragments in a scene; empty without a guide to a fit.
   *
   * @param fragments the fragments where they rest
   * @param world the directions of the world axes
   * @param err receives a note about the scan of the fragments, if there is one
   * @throws IOException if the scan of the fragments cannot be read
   * @throws PalpateException exit code 2, if the gap or the scan is wrong
   */
  public Optional<FaceFit> faceFit(
      SegmentedVolume fragments, CoordinateSystem world, PrintWriter err) throws IOException {
    Optional<String> text = fit();
    if (text.isEmpty()) {
      return Optional.empty();
    }
    List<BitCube> cubes = fragments.segments().stream().map(Segment::bits).toList();
    return Optional.of(
        new FaceFit(
            fragments.grids(),
            cubes,
            fitGrey.partialVoxels(fragments, world, err),
            gapMm(text.get())));
  }

  /** Returns what hands fits over to the guide. */
  public FitExchange fits() {
    return fits;
  }

  /** Whether grey values are needed. */
  public boolean needsGrey() {
    return effects.needsGrey() || materials.areWanted();
  }

  /**
   * Returns the files that the options name, which no output may replace.
   *
   * @throws VolumeFormatException if the scan of the fragments cannot be read
   */
  public List<Path> files() throws VolumeFormatException {
    return Stream.of(
            guides.stream().filter(text -> EffectOptions.kind(text).equals("path")).map(this::file),
            materials.file().stream(),
            fitGrey.files().stream())
        .flatMap(each -> each)
        .toList();
  }

  /** Whether materials follow from grey values. */
  public boolean hasGreyMaterials() {
    return materials.areWanted();
  }

  /**
   * Returns what the hand feels beside plain contact.
   *
   * @param mass the mass of the interaction point or tool
   * @throws IOException if a file cannot be read
   * @throws PalpateException exit code 2, if an option is wrong
   */
  public FeelSettings settings(
      VolumeSource source, SegmentedVolume segments, Optional<MassSettings> mass)
      throws IOException {
    return new FeelSettings(effects(source, segments), mass, materials.materials(source));
  }

  private List<EffectPlan> effects(VolumeSource source, SegmentedVolume segments)
      throws IOException {
    GuideStrength strength = strength();
    List<EffectPlan> plans = new ArrayList<>(effects.plans(source, segments));
    for (String text : guides) {
      String kind = EffectOptions.kind(text);
      plans.add(
          switch (kind) {
            case "away" -> away(text, segments, strength);
            case "path" -> path(text, strength);
            case "fit" -> Guides.fit(fits, strength);
            default -> plan(text, kind, strength);
          });
    }
    return plans;
  }

  private GuideStrength strength() {
    OptionalDouble range = RANGE.checkGiven(guideRange);
    return new GuideStrength(
        STRENGTH.checkGiven(guideStiffness),
        PULL.checkGiven(guideForce),
        range.orElse(Double.POSITIVE_INFINITY));
  }

  private static EffectPlan plan(String text, String kind, GuideStrength strength) {
    return switch (kind) {
      case "axis" -> {
        double[] n = numbers(text, "axis:X,Y,Z,DX,DY,DZ", 6, 3);
        yield Guides.axis(vector(n, 0), vector(n, 3), strength);
      }
      case "plane" -> {
        double[] n = numbers(text, "plane:X,Y,Z,NX,NY,NZ", 6, 3);
        yield Guides.plane(vector(n, 0), vector(n, 3), strength);
      }
      case "hinge" -> {
        double[] n = numbers(text, "hinge:X,Y,Z,DX,DY,DZ", 6, 3);
        yield Guides.hinge(vector(n, 0), vector(n, 3), strength);
      }
      case "align" -> Guides.align(vector(numbers(text, "align:DX,DY,DZ", 3, 0), 0), strength);
      case "sphere" -> {
        double[] n = numbers(text, "sphere:X,Y,Z,R", 4, 4);
        if (!(n[3] > 0)) {
          throw PalpateException.wrongUse(
              "the radius must be positive", "--guide " + text, "write sphere:X,Y,Z,R");
        }
        yield Guides.ball(vector(n, 0), n[3], strength);
      }
      default ->
          throw PalpateException.wrongUse(
              "there is no such guide",
              "--guide " + text,
              "choose axis, plane, sphere, hinge, path, away, align or fit");
    };
  }

  /**
   * Returns the numbers of a guide.
   *
   * @param direction the index of the first of three that are not all zero; {@code count} if none
   */
  private static double[] numbers(String text, String form, int count, int direction) {
    String[] words = EffectOptions.values(text).split(",", -1);
    double[] found = Arrays.stream(words).mapToDouble(NumberParser::number).toArray();
    boolean isRead =
        found.length == count && Arrays.stream(found).allMatch(n -> Math.abs(n) <= MOST_MM);
    if (!isRead) {
      throw PalpateException.wrongUse(
          "the guide cannot be read",
          "--guide " + text,
          "write " + form + " with " + count + " numbers from -1,000,000 to 1,000,000");
    }
    if (direction < count && !(vector(found, direction).length() > 0)) {
      throw PalpateException.wrongUse(
          "the direction is zero", "--guide " + text, "write " + form + " with a direction");
    }
    return found;
  }

  private static Vec3 vector(double[] numbers, int first) {
    return new Vec3(numbers[first], numbers[first + 1], numbers[first + 2]);
  }

  private Path file(String text) {
    try {
      String name = EffectOptions.values(text);
      if (!name.isBlank()) {
        return Path.of(name);
      }
    } catch (InvalidPathException e) {
      throw PalpateException.wrongUse(
          "the path is no file name", "--guide " + text, "write path:FILE.csv", e);
    }
    throw PalpateException.wrongUse(
        "the path has no file", "--guide " + text, "write path:FILE.csv");
  }

  private EffectPlan path(String text, GuideStrength strength) throws IOException {
    List<Vec3> positions = new ArrayList<>();
    for (double[] row : NumbersCsvReader.read(file(text), List.of("x", "y", "z"))) {
      positions.add(vector(row, 0));
    }
    if (positions.size() < 2 || positions.size() > PathShape.MOST_POSITIONS) {
      throw PalpateException.wrongUse(
          "a path has 2 to 1,000 positions and this one has " + NumberText.count(positions.size()),
          file(text).toString(),
          "leave out rows, or add some");
    }
    return Guides.path(positions, strength);
  }

  /** Returns the width of the gap of a fit; empty if the fit finds it. */
  private static OptionalDouble gapMm(String text) {
    String value = EffectOptions.values(text);
    if (value.equals("free")) {
      return OptionalDouble.empty();
    }
    double mm = text.equals("fit") ? 0 : NumberParser.number(value);
    if (!(mm >= 0 && mm <= FaceFit.MOST_GAP_MM)) {
      throw PalpateException.wrongUse(
          "the gap cannot be read",
          "--guide " + text,
          "write fit, fit:free, or fit:GAP with a width from 0 to 3 mm, as in fit:1");
    }
    return OptionalDouble.of(mm);
  }

  private static double marginMm(String text) {
    int comma = text.lastIndexOf(',');
    double mm = comma < 0 ? Double.NaN : NumberParser.number(text.substring(comma + 1));
    if (comma <= "away:".length() || !(mm > 0 && mm <= 1000)) {
      throw PalpateException.wrongUse(
          "the margin cannot be read",
          "--guide " + text,
          "write away:NAME,MM with a margin above 0 and up to 1,000 mm, as in away:nerve,3");
    }
    return mm;
  }

  private static EffectPlan away(String text, SegmentedVolume segments, GuideStrength strength) {
    double mm = marginMm(text);
    String values = EffectOptions.values(text);
    String name = values.substring(0, values.lastIndexOf(','));
    SegmentDistance distance = EffectOptions.distance(segments, "--guide ", text, name, mm);
    return Guides.away(distance, mm, strength);
  }
}
