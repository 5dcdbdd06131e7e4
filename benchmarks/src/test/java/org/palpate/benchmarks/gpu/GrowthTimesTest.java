package org.palpate.benchmarks.gpu;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GrowthTimesTest {
  @ParameterizedTest
  @ValueSource(ints = {1, 4})
  void everySecondEditRestoresTheSkull(int edge) {
    GrowthTimes growth = new GrowthTimes(48, edge);
    int voxels = growth.voxels();
    for (int n = 0; n < 50; n++) {
      growth.growAfterEdit();
      assertTrue(growth.voxels() < voxels, "edit " + n);
      growth.growAfterEdit();
      assertEquals(voxels, growth.voxels(), "edit " + n);
    }
    growth.growAll();
  }
}
