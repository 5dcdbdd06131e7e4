package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class SurfaceTintTest {
  private static final Vec3 SPACING = new Vec3(1, 2, 0.5);

  private static int value(SurfaceTint tint, Vec3 grid, int part) {
    int i = (int) Math.floor(grid.x - tint.lowMm().x / SPACING.x);
    int j = (int) Math.floor(grid.y - tint.lowMm().y / SPACING.y);
    int k = (int) Math.floor(grid.z - tint.lowMm().z / SPACING.z);
    return tint.cells().get(2 * ((k * tint.size(1) + j) * tint.size(0) + i) + part) & 255;
  }

  @Test
  void aSampleIsKnownAtItsPlaceAndNotFarAway() {
    Vec3 here = new Vec3(7.5, 3.5, 20.5);
    Vec3 there = new Vec3(17.5, 3.5, 20.5);
    SurfaceTint tint =
        SurfaceTint.of(
            List.of(new SurfaceTint.Sample(here, 0.2), new SurfaceTint.Sample(there, 1)), SPACING);
    assertEquals(255, value(tint, here, 1));
    assertEquals(51, value(tint, here, 0));
    assertEquals(255, value(tint, there, 0));
    assertEquals(0, value(tint, new Vec3(12.5, 3.5, 20.5), 1));
  }

  @Test
  void theValueBetweenTwoSamplesIsTheirMean() {
    Vec3 middle = new Vec3(5.5, 5.5, 5.5);
    SurfaceTint tint =
        SurfaceTint.of(
            List.of(
                new SurfaceTint.Sample(new Vec3(4.5, 5.5, 5.5), 0),
                new SurfaceTint.Sample(new Vec3(6.5, 5.5, 5.5), 1)),
            SPACING);
    double cover = value(tint, middle, 1);
    assertTrue(cover > 200, "cover " + cover);
    assertEquals(0.5, value(tint, middle, 0) / cover, 0.01);
  }
}
