package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Looks up places near a thin rod that crosses a large box, and near a thick one. */
class SurfaceCellsTest {
  private static final long SEED = Long.getLong("palpate.seed", 20);
  private static final int SIZE = 96;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(SIZE, SIZE, SIZE);

  /** Returns a rod along the diagonal of the box. */
  private static BitCube rod(int radius) {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 16; n < SIZE - 16; n++) {
      for (int i = n - radius; i <= n + radius; i++) {
        for (int j = n - radius; j <= n + radius; j++) {
          bits.set(i, j, n);
        }
      }
    }
    return bits;
  }

  @Test
  void aPlaceNearTheSurfaceHasThePointThatIsNearestToItsCell() {
    BitCube bits = rod(14);
    FragmentSurface surface = FragmentSurface.of(bits, GRID);
    SurfaceCells cells = new SurfaceCells(surface, bits, GRID, 1);
    Vec3 corner = new Vec3().set(surface.points().get(0));
    surface
        .points()
        .forEach(
            p ->
                corner.set(
                    Math.min(corner.x, p.x), Math.min(corner.y, p.y), Math.min(corner.z, p.z)));
    SplittableRandom random = new SplittableRandom(SEED);
    Set<SurfaceCells.Place> seen = EnumSet.noneOf(SurfaceCells.Place.class);
    for (int n = 0; n < 4000; n++) {
      Vec3 p = new Vec3(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(SIZE));
      Vec3 centre = new Vec3(centre(p.x, corner.x), centre(p.y, corner.y), centre(p.z, corner.z));
      double nearest = Double.POSITIVE_INFINITY;
      for (Vec3 q : surface.points()) {
        nearest = Math.min(nearest, centre.sub(q, new Vec3()).length());
      }
      SurfaceCells.Place place = cells.place(p.x, p.y, p.z);
      seen.add(place);
      if (nearest < 5) {
        assertEquals(SurfaceCells.Place.NEAR, place, "seed " + SEED);
        assertEquals(nearest, centre.sub(cells.point(), new Vec3()).length(), 1e-9, "seed " + SEED);
      } else if (place != SurfaceCells.Place.NEAR) {
        boolean isIn = bits.get((int) p.x, (int) p.y, (int) p.z);
        assertEquals(isIn, place == SurfaceCells.Place.DEEP, "seed " + SEED);
      }
    }
    assertEquals(EnumSet.allOf(SurfaceCells.Place.class), seen, "seed " + SEED);
  }

  /** Returns the coordinate of the middle of the cell in which a place lies. */
  private static double centre(double at, double lowest) {
    double low = lowest - 6;
    return low + Math.floor(at - low) + 0.5;
  }

  @Test
  void theMemoryGrowsWithTheSurfaceAndNotWithTheBox() {
    BitCube bits = rod(1);
    FragmentSurface surface = FragmentSurface.of(bits, GRID);
    SurfaceCells cells = new SurfaceCells(surface, bits, GRID, 1);
    double box = Math.pow(SIZE - 32, 3);
    assertTrue(cells.storedCells() < 0.5 * box, cells.storedCells() + " of " + box);
    assertTrue(cells.storedCells() < 400L * surface.points().size(), "" + cells.storedCells());
  }
}
