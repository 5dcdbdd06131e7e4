package org.palpate.io.label;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

class ValueStatisticsTest {
  /** The value of a voxel. */
  private interface Values {
    double at(int i, int j);
  }

  private static ValueStatistics.Summary summary(
      VoxelType type, Optional<LabelTable> table, Values values) {
    return summary(20, 10, type, table, values);
  }

  private static ValueStatistics.Summary summary(
      int sizeX, int sizeY, VoxelType type, Optional<LabelTable> table, Values values) {
    VolumeHeader header =
        new VolumeHeader(
            "test",
            VoxelGrid.ofUnitVoxels(sizeX, sizeY, 2),
            type,
            ValueRange.of(type),
            CoordinateSystem.LPS,
            table,
            List.of());
    ValueStatistics statistics = new ValueStatistics(header);
    VoxelSlice slice = new VoxelSlice(sizeX, sizeY, type.fitsInt());
    for (int n = 0; n < slice.count(); n++) {
      double value = values.at(n % sizeX, n / sizeX);
      if (type.fitsInt()) {
        slice.integers()[n] = (int) value;
      } else {
        slice.doubles()[n] = value;
      }
    }
    statistics.accept(0, slice);
    statistics.accept(1, slice);
    return statistics.summary();
  }

  private static ValueStatistics.Summary summary(VoxelType type, Values values) {
    return summary(type, Optional.empty(), values);
  }

  @Test
  void regionsOfWholeNumbersAreLabels() {
    for (VoxelType type : List.of(VoxelType.UINT8, VoxelType.INT32, VoxelType.FLOAT32)) {
      ValueStatistics.Summary found = summary(type, (i, j) -> Math.floorDiv(i, 5));
      assertEquals(List.of(1L, 2L, 3L), found.labels(), "" + type);
      assertEquals(0, found.low());
      assertEquals(3, found.high());
    }
  }

  /** The median label of pairs is followed by itself half the time, and here a third of it. */
  @Test
  void labelsFillRegionsAlongX() {
    int[] hardlyFlat = {1, 1, 2, 2, 3, 3, 1, 2, 3};
    for (VoxelType type : List.of(VoxelType.UINT8, VoxelType.INT32)) {
      assertEquals(List.of(1L, 2L, 3L), summary(type, (i, j) -> i / 2 % 4).labels(), "" + type);
      assertEquals(List.of(), summary(type, (i, j) -> hardlyFlat[i % 9]).labels(), "" + type);
    }
  }

  @Test
  void valuesThatVaryAreIntensities() {
    for (VoxelType type : List.of(VoxelType.UINT8, VoxelType.INT32, VoxelType.FLOAT32)) {
      assertEquals(List.of(), summary(type, (i, j) -> (i * 7 + j) % 11).labels(), "" + type);
    }
    assertEquals(
        List.of(), summary(VoxelType.FLOAT32, (i, j) -> Math.floorDiv(i, 5) + 0.5).labels());
    assertEquals(
        List.of(),
        summary(VoxelType.INT16, (i, j) -> Math.floorDiv(i, 5) - 1).labels(),
        "a label is no number below 0");
  }

  @Test
  void theBackgroundOfAMaskIsItsLowerValue() {
    assertEquals(List.of(255L), summary(VoxelType.UINT8, (i, j) -> i % 2 * 255).labels());
    assertEquals(List.of(9L), summary(VoxelType.UINT8, (i, j) -> i % 2 == 0 ? 4 : 9).labels());
    assertEquals(List.of(4L), summary(VoxelType.UINT8, (i, j) -> 4).labels());
    assertEquals(List.of(), summary(VoxelType.UINT8, (i, j) -> 0).labels());
  }

  @Test
  void aTableDeclaresLabelsThatVary() {
    Values varied = (i, j) -> (i * 7 + j) % 3;
    assertEquals(List.of(), summary(VoxelType.UINT8, varied).labels());
    assertEquals(
        List.of(1L, 2L), summary(VoxelType.UINT8, Optional.of(LabelTable.EMPTY), varied).labels());
    LabelTable both = table(1, 2);
    assertEquals(List.of(1L, 2L), summary(VoxelType.UINT8, Optional.of(both), varied).labels());
    assertEquals(
        List.of(),
        summary(VoxelType.UINT8, Optional.of(table(1)), varied).labels(),
        "it does not name every value");
    assertEquals(
        List.of(4L, 9L),
        summary(VoxelType.UINT8, Optional.of(table(4, 9)), (i, j) -> i % 2 == 0 ? 4 : 9).labels(),
        "two named labels have no background");
  }

  private static LabelTable table(long... values) {
    Map<Long, LabelTable.Label> labels = new java.util.TreeMap<>();
    for (long value : values) {
      labels.put(value, new LabelTable.Label("n" + value, 0));
    }
    return new LabelTable(labels);
  }

  @Test
  void tooManyValuesAreIntensities() {
    assertEquals(
        200,
        summary(VoxelType.INT32, Optional.of(LabelTable.EMPTY), (i, j) -> 20 * j + i + 1)
            .labels()
            .size());
    double[] many = new double[1100];
    for (int n = 0; n < many.length; n++) {
      many[n] = n + 1;
    }
    assertEquals(List.of(), ValueStatistics.ofSample(many).labels());
  }

  @Test
  void aTableDeclaresUpTo1024Labels() {
    Optional<LabelTable> declares = Optional.of(LabelTable.EMPTY);
    for (VoxelType type : List.of(VoxelType.UINT16, VoxelType.INT32)) {
      Values most = (i, j) -> Math.min(1023, 205 * j + i) + 1;
      Values tooMany = (i, j) -> 205 * j + i + 1;
      assertEquals(1024, summary(205, 5, type, declares, most).labels().size(), "" + type);
      assertEquals(List.of(), summary(205, 5, type, declares, tooMany).labels(), "" + type);
    }
  }

  @Test
  void valuesThatAreNotFiniteAreCountedAndNoExtremes() {
    ValueStatistics.Summary found =
        summary(
            VoxelType.FLOAT32,
            (i, j) -> i == 0 ? Double.NaN : i == 1 ? Double.NEGATIVE_INFINITY : -0.0 - j);
    assertEquals(40, found.notFinite());
    assertEquals(-9, found.low());
    assertEquals(0, found.high());
    ValueStatistics.Summary none = summary(VoxelType.FLOAT64, (i, j) -> Double.NaN);
    assertEquals(Double.POSITIVE_INFINITY, none.low());
    assertEquals(List.of(), none.thresholds());
  }

  @Test
  void thresholdsSeparateThreeMatters() {
    for (VoxelType type : List.of(VoxelType.INT16, VoxelType.FLOAT32)) {
      ValueStatistics.Summary found =
          summary(type, (i, j) -> (i < 7 ? -900 : i < 14 ? 100 : 1500) + j);
      double tissue = found.thresholds().get(0);
      double bone = found.thresholds().get(1);
      assertTrue(tissue > -891 && tissue <= 100, type + ": tissue from " + tissue);
      assertTrue(bone > 109 && bone <= 1500, type + ": bone from " + bone);
    }
  }

  @Test
  void aCtScanHasAirWaterAndBoneAndNotMuchElse() {
    assertTrue(isHounsfield((i, j) -> (i < 7 ? -900 : i < 14 ? 100 : 1500) + j));
    assertFalse(isHounsfield((i, j) -> (i < 7 ? -800 : i < 14 ? 100 : 1500) + j), "no air");
    assertFalse(isHounsfield((i, j) -> i < 7 ? -1000 : i < 14 ? 250 : 1500), "no water");
    assertFalse(isHounsfield((i, j) -> i < 7 ? -1000 : 100), "no bone");
    assertFalse(isHounsfield((i, j) -> padded(i, 12)), "padding in most voxels");
    assertTrue(isHounsfield((i, j) -> padded(i, 9)));
  }

  private static double padded(int i, int padding) {
    return i < padding ? -2000 : i < 15 ? -1000 : i < 18 ? 0 : 1000;
  }

  private static boolean isHounsfield(Values values) {
    boolean exact = summary(VoxelType.INT16, values).hounsfield();
    assertEquals(exact, summary(VoxelType.FLOAT32, values).hounsfield());
    return exact;
  }
}
