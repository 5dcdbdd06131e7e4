package org.palpate.app.options;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.palpate.app.process.PalpateException;
import org.palpate.force.EffectPlan;
import org.palpate.force.effect.Effects;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.io.file.NumberParser;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine.Option;

/** The option of effects. */
public final class EffectOptions {
  private static final String OPTION = "--effect ";
  private static final Range VISCOSITY = new Range(1e-6, 0.1, "0.000001 to 0.1 N s/mm");
  private static final Range NEWTON = new Range(1e-3, 1000, "0.001 to 1,000 N");
  private static final Range REACH = new Range(1e-3, 1000, "0.001 to 1,000 mm");
  private static final Range HERTZ = new Range(1, 400, "1 to 400 Hz");
  private static final Range BUMP = new Range(1e-3, 10, "0.001 to 10 mm");

  @Option(
      names = "--effect",
      paramLabel = "KIND:VALUES",
      description = {
        "Adds an effect; may be repeated: viscosity:NS/MM (resists every motion), magnet:NAME,N,MM"
            + " (draws to a segment from MM on, with N at most), stickslip:N (sticks to surfaces up"
            + " to N), vibration:HZ,N (shakes in contact), texture:MM (bumps where grey values"
            + " vary; a variation as large as the step at the surface makes a bump of MM)."
      })
  private List<String> effects = List.of();

  /** The numbers that a value may have, and the same in words. */
  private record Range(double low, double high, String text) {
    boolean contains(double value) {
      return value >= low && value <= high;
    }
  }

  /**
   * Checks the forms, before a volume is read.
   *
   * @throws PalpateException exit code 2, if an effect is wrong
   */
  void check() {
    effects.forEach(EffectOptions::numbers);
  }

  /** Whether an effect needs grey values. */
  public boolean needsGrey() {
    return effects.stream().anyMatch(text -> kind(text).equals("texture"));
  }

  /**
   * Returns the plans of the effects in their order.
   *
   * @throws VolumeFormatException if grey values are needed and cannot be read
   * @throws PalpateException exit code 2, if an effect does not fit the volume
   */
  List<EffectPlan> plans(VolumeSource source, SegmentedVolume segments)
      throws VolumeFormatException {
    List<EffectPlan> plans = new ArrayList<>();
    for (String text : effects) {
      double[] v = numbers(text);
      plans.add(
          switch (kind(text)) {
            case "viscosity" -> Effects.viscosity(v[0]);
            case "stickslip" -> Effects.stickSlip(v[0]);
            case "vibration" -> Effects.vibration(v[0], v[1]);
            case "magnet" -> {
              String values = values(text);
              String name = values.substring(0, values.indexOf(','));
              yield Effects.magnet(distance(segments, OPTION, text, name, v[1]), v[0], v[1]);
            }
            default -> texture(source, text, v[0]);
          });
    }
    return plans;
  }

  private static EffectPlan texture(VolumeSource source, String text, double mm)
      throws VolumeFormatException {
    OptionalDouble threshold = source.firstThreshold();
    if (threshold.isEmpty()) {
      throw PalpateException.wrongUse(
          "a texture needs grey values",
          OPTION + text,
          "choose segments by a threshold, as in --segment 'bone=>=1500'");
    }
    GreyIsosurface surface =
        GreyIsosurface.ofThreshold(source.greyValues(), threshold.getAsDouble());
    return Effects.texture(surface.volume(), mm / surface.contrast());
  }

  /** Returns what stands before the first colon; all of it without one. */
  static String kind(String text) {
    int colon = text.indexOf(':');
    return colon < 0 ? text : text.substring(0, colon);
  }

  /** Returns what stands after the first colon; nothing without one. */
  static String values(String text) {
    return text.substring(Math.min(text.length(), kind(text).length() + 1));
  }

  private static double[] numbers(String text) {
    return switch (kind(text)) {
      case "viscosity" -> numbers(text, "viscosity:NS/MM", 0, VISCOSITY);
      case "stickslip" -> numbers(text, "stickslip:N", 0, NEWTON);
      case "vibration" -> numbers(text, "vibration:HZ,N", 0, HERTZ, NEWTON);
      case "magnet" -> numbers(text, "magnet:NAME,N,MM", 1, NEWTON, REACH);
      case "texture" -> numbers(text, "texture:MM", 0, BUMP);
      default ->
          throw PalpateException.wrongUse(
              "there is no such effect",
              OPTION + text,
              "choose viscosity, magnet, stickslip, vibration or texture with its values");
    };
  }

  /** Returns the numbers of an effect after its first words. */
  private static double[] numbers(String text, String form, int first, Range... ranges) {
    String[] words = values(text).split(",", -1);
    double[] found = Arrays.stream(words).skip(first).mapToDouble(NumberParser::number).toArray();
    boolean fits = found.length == ranges.length;
    for (int n = 0; fits && n < found.length; n++) {
      fits = ranges[n].contains(found[n]);
    }
    if (!fits) {
      String numbers = String.join(" and ", Arrays.stream(ranges).map(Range::text).toList());
      throw PalpateException.wrongUse(
          "the effect cannot be read", OPTION + text, "write " + form + " with " + numbers);
    }
    return found;
  }

  /**
   * Returns the distances from a segment.
   *
   * @param option the option that names it, with a blank
   * @param text the value of the option
   * @throws PalpateException exit code 2, if there is no such segment or its box is too large
   */
  static SegmentDistance distance(
      SegmentedVolume segments, String option, String text, String name, double reachMm) {
    Segment segment = NamedSegment.of(segments, option, text, name);
    VoxelGrid grid = segments.gridOf(segment);
    double voxels = SegmentDistance.voxelsFor(segment.bits(), grid, reachMm);
    if (voxels > SegmentDistance.MOST_VOXELS) {
      throw PalpateException.wrongUse(
          "the segment and its margin fill a box of "
              + NumberText.count(voxels)
              + " voxels, more than "
              + NumberText.count(SegmentDistance.MOST_VOXELS),
          option + text,
          "choose a smaller margin or a smaller segment");
    }
    int body = segments.segments().indexOf(segment);
    return new SegmentDistance(segment.bits(), grid, reachMm, body);
  }
}
