package org.palpate.app.options;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.palpate.app.process.PalpateException;
import org.palpate.io.GreyVolumes;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.scene.surface.GreyRange;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine.Option;

/** The option that says what drawn surfaces are made from. */
public final class SurfaceOptions {
  private static final String GREY = "grey";
  private static final double MEMORY_FRACTION = 0.25;
  private static final double SAMPLE = 100_000;
  private static final int MOST_LABELS = 64;

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
  public void check() {
    if (surface != null && !surface.equals(GREY) && !surface.equals("bits")) {
      throw PalpateException.wrongUse(
          "no such source of a surface", "--surface " + surface, "choose grey or bits");
    }
  }

  /** Refuses grey values where no segment came from any. */
  public void checkPossible(VolumeSource source) {
    if (GREY.equals(surface) && !isPossible(source)) {
      throw PalpateException.wrongUse(
          "a surface of grey values needs a segment made by a threshold",
          "--surface grey",
          "choose one with --segment NAME=>=VALUE, or leave --surface out");
    }
  }

  private static boolean isPossible(VolumeSource source) {
    return source.asked().stream().anyMatch(SurfaceOptions::isRange);
  }

  /**
   * What each segment was made of; none where surfaces go by bits.
   *
   * @param byDefault whether grey values are to be read where nothing was asked for
   */
  public List<Optional<GreyRange>> greys(VolumeSource source, boolean byDefault)
      throws VolumeFormatException {
    checkPossible(source);
    boolean asked = GREY.equals(surface);
    boolean unasked = surface == null && byDefault && isPossible(source) && fitsGreySurface(source);
    return asked || unasked ? ranges(source.asked(), source.greyValues()) : List.of();
  }

  /** Not for masks and labels, nor where the values would take most of the memory. */
  private static boolean fitsGreySurface(VolumeSource source) throws VolumeFormatException {
    double mostBytes = Runtime.getRuntime().maxMemory() * MEMORY_FRACTION;
    return source.hasGreyValues()
        ? hasManyValues(source.greyValues())
        : GreyVolumes.bytesFor(source.header()) < mostBytes && source.holdsIntensities();
  }

  /** Whether a sample says that they are no labels; quicker than to look at them all. */
  private static boolean hasManyValues(ScalarVolume values) {
    VoxelGrid grid = values.grid();
    int step = (int) Math.max(1, Math.cbrt((double) grid.voxelCount() / SAMPLE));
    Set<Double> seen = new HashSet<>();
    for (int k = 0; k < grid.sizeZ() && seen.size() <= MOST_LABELS; k += step) {
      for (int j = 0; j < grid.sizeY(); j += step) {
        for (int i = 0; i < grid.sizeX(); i += step) {
          seen.add(values.value(i, j, k));
        }
      }
    }
    return seen.size() > MOST_LABELS;
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
