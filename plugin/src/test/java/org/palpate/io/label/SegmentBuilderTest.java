package org.palpate.io.label;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class SegmentBuilderTest {
  private static final long SEED = Seeds.seed();
  private static final int X = 13;
  private static final int Y = 6;
  private static final int Z = 9;

  private final SplittableRandom random = new SplittableRandom(SEED);

  /** A volume in memory. */
  private static final class Values implements VolumeReader {
    private final double[] values;
    private final boolean integer;
    private final Optional<LabelTable> labels;

    Values(double[] values, boolean integer, Optional<LabelTable> labels) {
      this.values = values;
      this.integer = integer;
      this.labels = labels;
    }

    @Override
    public VolumeHeader header() {
      VoxelType type = integer ? VoxelType.INT32 : VoxelType.FLOAT64;
      return new VolumeHeader(
          "test",
          VoxelGrid.ofUnitVoxels(X, Y, Z),
          type,
          ValueRange.of(type),
          CoordinateSystem.LPS,
          labels,
          List.of());
    }

    @Override
    public void read(SliceSink sink) throws VolumeFormatException {
      VoxelSlice slice = new VoxelSlice(X, Y, integer);
      for (int k = 0; k < Z; k++) {
        for (int n = 0; n < slice.count(); n++) {
          double value = values[k * X * Y + n];
          if (integer) {
            slice.integers()[n] = (int) value;
          } else {
            slice.doubles()[n] = value;
          }
        }
        sink.accept(k, slice);
      }
    }

    @Override
    public String sourceName() {
      return "memory";
    }

    @Override
    public List<Path> files() {
      return List.of();
    }
  }

  private Values values(boolean integer, double[] specials) {
    double[] values = new double[X * Y * Z];
    for (int n = 0; n < values.length; n++) {
      values[n] =
          random.nextInt(4) == 0
              ? specials[random.nextInt(specials.length)]
              : random.nextInt(-20, 20) + (integer ? 0 : 0.5 * random.nextInt(3));
    }
    return new Values(values, integer, Optional.empty());
  }

  private static void requireRule(Values volume, SegmentSpec spec, BitCube bits) {
    for (int n = 0; n < volume.values.length; n++) {
      assertEquals(
          spec.rule().selects(volume.values[n]),
          bits.get(n % X, n / X % Y, n / X / Y),
          spec + " value=" + volume.values[n] + " seed=" + SEED);
    }
  }

  private static List<SegmentSpec> specs() {
    List<SegmentSpec> specs = new ArrayList<>();
    specs.add(SegmentSpec.nonzero("nonzero"));
    specs.add(SegmentSpec.atLeast("high", 3.5));
    specs.add(SegmentSpec.atLeast("beyond", 1e300));
    specs.add(SegmentSpec.range("low", Double.NEGATIVE_INFINITY, -7));
    specs.add(SegmentSpec.range("band", -2.5, 4));
    specs.add(SegmentSpec.range("between", 0.25, 0.75));
    specs.add(SegmentSpec.labels("labels", 7, -3, 12));
    specs.add(SegmentSpec.labels("again", 7, 70_000));
    return specs;
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void everyVoxelFollowsTheRuleOfItsSegment(boolean integer) throws VolumeFormatException {
    double[] specials =
        integer
            ? new double[] {0, 7, Integer.MIN_VALUE, Integer.MAX_VALUE, 70_000}
            : new double[] {
              0, -0.0, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e301, 70_000
            };
    Values volume = values(integer, specials);
    SegmentedVolume built = SegmentBuilder.read(volume, specs());
    for (int n = 0; n < specs().size(); n++) {
      Segment segment = built.segments().get(n);
      assertEquals(specs().get(n).name(), segment.name());
      requireRule(volume, specs().get(n), segment.bits());
    }
  }

  @Test
  void labelsThatDoNotOverlapAreLookedUp() throws VolumeFormatException {
    Values volume = values(true, new double[] {0, 65_535, 65_536, -1});
    List<SegmentSpec> specs = new ArrayList<>();
    for (int label = 0; label < 20; label++) {
      specs.add(SegmentSpec.labels("l" + label, label, label == 3 ? 65_535 : 100 + label));
    }
    SegmentedVolume built = SegmentBuilder.read(volume, specs);
    for (int n = 0; n < specs.size(); n++) {
      requireRule(volume, specs.get(n), built.segments().get(n).bits());
    }
  }

  @Test
  void aNameStandsForTheLabelsOfTheTable() throws VolumeFormatException {
    Values plain = values(true, new double[] {0, 7});
    LabelTable table =
        new LabelTable(
            Map.of(
                7L, new LabelTable.Label("Jaw", 0x102030),
                3L, new LabelTable.Label("Jaw", 0),
                4L, new LabelTable.Label("Skull", 0)));
    Values named = new Values(plain.values, true, Optional.of(table));
    SegmentSpec jaw = SegmentSpec.parse("j=name:Jaw");
    BitCube bits = SegmentBuilder.read(named, List.of(jaw)).segments().get(0).bits();
    requireRule(named, SegmentSpec.labels("j", 3, 7), bits);
    assertEquals(
        "the volume has no label of this name: --segment j=name:Nose: choose one that palpate info"
            + " prints, or write label:7",
        assertThrows(
                VolumeFormatException.class,
                () -> SegmentBuilder.read(named, List.of(SegmentSpec.parse("j=name:Nose"))))
            .getMessage());
    assertTrue(
        assertThrows(VolumeFormatException.class, () -> SegmentBuilder.read(plain, List.of(jaw)))
            .getMessage()
            .startsWith("the volume names no label: --segment j=name:Jaw: "));
  }

  @Test
  void coloursAreThoseAskedForOrDiffer() throws VolumeFormatException {
    Values volume = values(true, new double[] {0});
    List<Segment> segments =
        SegmentBuilder.read(
                volume,
                List.of(
                    SegmentSpec.nonzero("a"),
                    SegmentSpec.nonzero("b"),
                    SegmentSpec.nonzero("c").withRgb(0x123456)))
            .segments();
    assertTrue(segments.get(0).rgb() != segments.get(1).rgb());
    assertEquals(0x123456, segments.get(2).rgb());
  }

  @Test
  void otsusThresholdsAreTheBestOfAllPairs() {
    for (int round = 0; round < 200; round++) {
      List<double[]> histogram = new ArrayList<>();
      double value = random.nextDouble(-100, 100);
      double step = random.nextDouble(0.5, 3);
      int size = random.nextInt(3, 9);
      for (int n = 0; n < size; n++) {
        histogram.add(new double[] {value + n * step, random.nextInt(1, 50)});
      }
      List<Double> found = OtsuThresholds.of(histogram);
      double least = Double.POSITIVE_INFINITY;
      for (int a = 1; a < size - 1; a++) {
        for (int b = a + 1; b < size; b++) {
          least = Math.min(least, scatter(histogram, a, b));
        }
      }
      int first = firstAtLeast(histogram, found.get(0));
      int second = firstAtLeast(histogram, found.get(1));
      assertTrue(first >= 1 && second > first, "seed=" + SEED + " round=" + round);
      assertEquals(
          least,
          scatter(histogram, first, second),
          1e-9 * Math.max(1, least),
          "seed=" + SEED + " round=" + round);
    }
    assertEquals(List.of(), OtsuThresholds.of(List.of(new double[] {1, 5}, new double[] {2, 5})));
  }

  private static int firstAtLeast(List<double[]> histogram, double value) {
    int n = 0;
    while (n < histogram.size() && histogram.get(n)[0] < value - 1e-9) {
      n++;
    }
    return n;
  }

  /** Returns the sum of the squared distances of all values from the mean of their class. */
  private static double scatter(List<double[]> histogram, int a, int b) {
    int[] ends = {0, a, b, histogram.size()};
    double all = 0;
    for (int part = 0; part < 3; part++) {
      double count = 0;
      double sum = 0;
      for (double[] entry : histogram.subList(ends[part], ends[part + 1])) {
        count += entry[1];
        sum += entry[0] * entry[1];
      }
      for (double[] entry : histogram.subList(ends[part], ends[part + 1])) {
        double apart = entry[0] - sum / count;
        all += entry[1] * apart * apart;
      }
    }
    return all;
  }
}
