package org.palpate.app.options;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.palpate.app.process.PalpateException;
import org.palpate.io.GreyVolumes;
import org.palpate.io.file.NumberParser;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.scene.ClipPlane;
import org.palpate.scene.ClipPlane.Direction;
import org.palpate.scene.DeformationColour;
import org.palpate.scene.DeformationColour.Measure;
import org.palpate.scene.surface.GreyRange;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine.Option;

/** The options of drawn surfaces: their source, and the plane that cuts them open. */
public final class SurfaceOptions {
  /** The name of the option that colours deformed surfaces. */
  public static final String DEFORMED = "--colour-by";

  private static final String GREY = "grey";
  private static final double MEMORY_FRACTION = 0.25;
  private static final double SAMPLE_SIZE = 100_000;
  private static final int MAX_LABELS = 64;

  @Option(
      names = "--surface",
      paramLabel = "WHAT",
      description = {
        "Source of the drawn surfaces: grey (grey values, if a segment is a threshold or a range)"
            + " or bits (the voxels that are touched). Default: grey if possible; in a window only"
            + " if the grey values are read anyway."
      })
  private String surface;

  @Option(
      names = "--clip",
      paramLabel = "PLANE",
      description = {
        "Cuts the surfaces open by a plane across an axis of the world (x, y or z), or by one that"
            + " faces the viewer (view). It leads through the interaction point. x:MM, y:MM and"
            + " z:MM put it at a place on the axis."
      })
  private String clip;

  @Option(
      names = DEFORMED,
      paramLabel = "MEASURE",
      description = {
        "Colours deformed surfaces, from purple to yellow: displacement (10 mm is yellow) or strain"
            + " (an equivalent strain of 0.3). displacement:MM and strain:PART set another value."
      })
  private String deformed;

  /**
   * Checks that the values are known.
   *
   * @throws PalpateException exit code 2, if they are not
   */
  public void check() {
    clip();
    deformed();
    if (surface != null && !surface.equals(GREY) && !surface.equals("bits")) {
      throw PalpateException.wrongUse(
          "there is no such source of a surface", "--surface " + surface, "choose grey or bits");
    }
  }

  /**
   * Returns the clipping plane, if one was asked for.
   *
   * @throws PalpateException exit code 2, if it cannot be read
   */
  public Optional<ClipPlane.Start> clip() {
    if (clip == null) {
      return Optional.empty();
    }
    String[] parts = clip.split(":", -1);
    Optional<Direction> direction =
        Stream.of(Direction.values())
            .filter(known -> known != Direction.OFF && known.toString().equals(parts[0]))
            .findFirst();
    boolean hasPlace = parts.length == 2 && direction.filter(Direction::isAcrossAxis).isPresent();
    double mm = hasPlace ? NumberParser.number(parts[1]) : Double.NaN;
    if (direction.isEmpty() || (parts.length > 1 && !Double.isFinite(mm))) {
      throw PalpateException.wrongUse(
          "the clipping plane cannot be read",
          "--clip " + clip,
          "write x, y, z or view, or a place on an axis in mm, as in x:12.5");
    }
    return Optional.of(
        new ClipPlane.Start(
            direction.get(), hasPlace ? OptionalDouble.of(mm) : OptionalDouble.empty()));
  }

  /**
   * Returns the colours of deformed surfaces, if they were asked for.
   *
   * @throws PalpateException exit code 2, if they cannot be read
   */
  public Optional<DeformationColour> deformed() {
    if (deformed == null) {
      return Optional.empty();
    }
    String[] parts = deformed.split(":", -1);
    Optional<Measure> measure =
        Stream.of(Measure.values()).filter(known -> known.toString().equals(parts[0])).findFirst();
    double most =
        parts.length == 2
            ? NumberParser.number(parts[1])
            : measure.map(Measure::usualMost).orElse(Double.NaN);
    if (measure.isEmpty() || parts.length > 2 || !(most > 0 && Double.isFinite(most))) {
      throw PalpateException.wrongUse(
          "the colours of deformed surfaces cannot be read",
          DEFORMED + " " + deformed,
          "write displacement or strain, or the value of the last colour too, as in strain:0.2");
    }
    return Optional.of(new DeformationColour(measure.get(), most));
  }

  /**
   * Checks that something deforms if its colours were asked for.
   *
   * @throws PalpateException exit code 2, if nothing does
   */
  public void checkDeformed(ElasticOptions elastic) {
    if (deformed != null && !elastic.isWanted()) {
      throw PalpateException.wrongUse(
          "no segment is elastic", DEFORMED, "add --elastic NAME=young:PA, or leave it out");
    }
  }

  /**
   * Checks that a surface of grey values is possible if one was asked for.
   *
   * @throws PalpateException exit code 2, if it is not
   */
  public void checkPossible(VolumeSource source) {
    if (GREY.equals(surface) && !isPossible(source)) {
      throw PalpateException.wrongUse(
          "a surface of grey values needs a segment made by a threshold",
          "--surface grey",
          "choose one with --segment NAME=>=VALUE, or leave --surface out");
    }
  }

  private static boolean isPossible(VolumeSource source) {
    return source.requested().stream().anyMatch(SurfaceOptions::isRange);
  }

  /**
   * Returns the range of grey values of each segment; an empty list if surfaces are made of bits.
   *
   * @param byDefault whether to use grey values if the user did not choose
   */
  public List<Optional<GreyRange>> greys(VolumeSource source, boolean byDefault)
      throws VolumeFormatException {
    checkPossible(source);
    boolean isRequired = GREY.equals(surface);
    boolean chosen = surface == null && byDefault && isPossible(source) && fitsGreySurface(source);
    return isRequired || chosen ? ranges(source.requested(), source.greyValues()) : List.of();
  }

  /** Whether the values are not a mask or labels and fit into the memory. */
  private static boolean fitsGreySurface(VolumeSource source) throws VolumeFormatException {
    double maxBytes = Runtime.getRuntime().maxMemory() * MEMORY_FRACTION;
    return source.hasGreyValues()
        ? hasManyValues(source.greyValues())
        : GreyVolumes.bytesFor(source.header()) < maxBytes && source.holdsIntensities();
  }

  /** Whether a regular sample has too many values for labels; faster than reading all values. */
  private static boolean hasManyValues(ScalarVolume values) {
    VoxelGrid grid = values.grid();
    int step = (int) Math.max(1, Math.cbrt((double) grid.voxelCount() / SAMPLE_SIZE));
    Set<Double> seen = new HashSet<>();
    for (int k = 0; k < grid.sizeZ() && seen.size() <= MAX_LABELS; k += step) {
      for (int j = 0; j < grid.sizeY(); j += step) {
        for (int i = 0; i < grid.sizeX(); i += step) {
          seen.add(values.value(i, j, k));
        }
      }
    }
    return seen.size() > MAX_LABELS;
  }

  private static boolean isRange(SegmentSpec spec) {
    return spec.rule() instanceof SegmentSpec.Range;
  }

  private static List<Optional<GreyRange>> ranges(List<SegmentSpec> specs, ScalarVolume values) {
    List<Optional<GreyRange>> ranges = new ArrayList<>();
    for (SegmentSpec spec : specs) {
      ranges.add(
          spec.rule() instanceof SegmentSpec.Range range
              ? Optional.of(new GreyRange(values, range.low(), range.high()))
              : Optional.empty());
    }
    return ranges;
  }
}
