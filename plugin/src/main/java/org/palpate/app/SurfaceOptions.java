package org.palpate.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.io.GreyVolumes;
import org.palpate.io.SegmentSpec;
import org.palpate.io.VolumeFormatException;
import org.palpate.scene.surface.GreyRange;
import org.palpate.volume.ScalarVolume;
import picocli.CommandLine.Option;

/** The option that says what drawn surfaces are made from. */
final class SurfaceOptions {
  private static final String GREY = "grey";
  private static final double MEMORY_SHARE = 0.25;

  @Option(
      names = "--surface",
      paramLabel = "WHAT",
      description = {
        "What the drawn surfaces go by: grey values, where a segment is a threshold or a range,",
        "or bits, the voxels that are touched. Default: grey where it can, in a window only",
        "where the grey values are read anyway."
      })
  private String surface;

  /** Refuses a word that is not known. */
  void check() {
    if (surface != null && !surface.equals(GREY) && !surface.equals("bits")) {
      throw PalpateException.wrongUse(
          "no such source of a surface", "--surface " + surface, "choose grey or bits");
    }
  }

  /**
   * What each segment was made of; none where surfaces go by bits.
   *
   * @param byDefault whether grey values are to be read where nothing was asked for
   */
  List<Optional<GreyRange>> greys(VolumeSource source, boolean byDefault)
      throws VolumeFormatException {
    boolean asked = GREY.equals(surface);
    boolean possible = source.asked().stream().anyMatch(SurfaceOptions::isRange);
    if (asked && !possible) {
      throw PalpateException.wrongUse(
          "a surface of grey values needs a segment made by a threshold",
          "--surface grey",
          "choose one with --segment NAME=>=VALUE, or leave --surface out");
    }
    boolean unasked = surface == null && byDefault && possible && isWorthIt(source);
    return asked || unasked ? ranges(source.asked(), source.greyValues()) : List.of();
  }

  /** Not for masks and labels, nor where the values would take most of the memory. */
  private static boolean isWorthIt(VolumeSource source) throws VolumeFormatException {
    double mostBytes = Runtime.getRuntime().maxMemory() * MEMORY_SHARE;
    return GreyVolumes.bytesFor(source.header()) < mostBytes && source.holdsIntensities();
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
