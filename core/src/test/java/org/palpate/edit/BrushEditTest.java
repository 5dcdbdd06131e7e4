package org.palpate.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Vec3;
import org.palpate.testing.SameVoxels;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class BrushEditTest {
  private static final int EDGE = 20;
  private static final Vec3 SPACING = new Vec3(0.5, 0.75, 1.25);
  private static final VoxelGrid GRID =
      new VoxelGrid(
          EDGE, EDGE, EDGE, SPACING, VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE).gridMmToWorld());

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final VoxelWriter writer =
      new VoxelWriter(new CollisionScene(List.of(bits)), EditListener.NONE);
  private final EditQueue queue = new EditQueue(GRID, 1);
  private final Place place = new Place();

  BrushEditTest() {
    writer.follow(place);
  }

  /** A tool that is where a test puts it, and that meets the voxel of that place. */
  private static final class Place implements ToolPlace {
    private final Vec3 touched = new Vec3();
    private final Vec3 device = new Vec3();
    private boolean isPlaced = true;

    @Override
    public boolean touchedPoint(int segment, Vec3 destGrid) {
      destGrid.set(touched);
      return isPlaced;
    }

    @Override
    public boolean devicePosition(int segment, Vec3 destGrid) {
      destGrid.set(device);
      return isPlaced;
    }

    @Override
    public boolean gridToDevice(int segment, AffineMap dest) {
      return false;
    }

    @Override
    public boolean meets(int segment, int i, int j, int k) {
      return i == (int) touched.x && j == (int) touched.y && k == (int) touched.z;
    }
  }

  @Test
  void aStrokePaintsTheVoxelsWhoseCentresExactArithmeticFindsNearItsPath() {
    int painted = 0;
    for (int run = 0; run < 60; run++) {
      boolean solid = run % 2 == 0;
      BitCube before = bits.copy();
      BrushPath path = new BrushPath();
      double radiusMm = random.nextDouble(0.6, 2); // 8 of them are longer than the path
      Vec3 from = anywhere();
      Vec3 to = new Vec3(from.x + random.nextDouble(4), from.y - 2, from.z + random.nextDouble(3));
      paint(path, from, radiusMm, solid);
      paint(path, to, radiusMm, solid);
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int i = n % EDGE;
        int j = n / EDGE % EDGE;
        int k = n / (EDGE * EDGE);
        int side = exactSide(from, to, radiusMm, i, j, k);
        boolean expected = side > 0 ? solid : before.get(i, j, k);
        assertTrue(side == 0 || bits.get(i, j, k) == expected, "seed " + Seeds.seed() + " " + n);
        painted += side > 0 ? 1 : 0;
      }
    }
    assertTrue(painted > 1000, "painted " + painted);
  }

  private Vec3 anywhere() {
    return new Vec3(random.nextDouble(EDGE), random.nextDouble(EDGE), random.nextDouble(EDGE));
  }

  private void paint(BrushPath path, Vec3 at, double radiusMm, boolean solid) {
    (solid ? place.device : place.touched).set(at);
    apply(BrushEdit.atTool(0, path, radiusMm, solid, BrushLimits.NONE));
  }

  /**
   * Returns 1 if a centre lies within the radius of a straight path, -1 if not, and 0 if it lies so
   * near to the boundary that rounding decides.
   */
  private static int exactSide(Vec3 from, Vec3 to, double radiusMm, int i, int j, int k) {
    BigDecimal[] c = relative(i + 0.5, j + 0.5, k + 0.5, from);
    BigDecimal[] way = relative(to.x, to.y, to.z, from);
    BigDecimal along = dot(c, way);
    BigDecimal square = dot(way, way);
    BigDecimal radius = new BigDecimal(radiusMm);
    BigDecimal slack; // times the squared length of the path if the nearest point is within it
    if (along.signum() <= 0) {
      slack = radius.multiply(radius).subtract(dot(c, c));
    } else if (along.compareTo(square) >= 0) {
      BigDecimal[] e = relative(i + 0.5, j + 0.5, k + 0.5, to);
      slack = radius.multiply(radius).subtract(dot(e, e));
    } else {
      slack =
          radius.multiply(radius).subtract(dot(c, c)).multiply(square).add(along.multiply(along));
    }
    return slack.abs().doubleValue() < 1e-9 ? 0 : slack.signum();
  }

  private static BigDecimal[] relative(double x, double y, double z, Vec3 origin) {
    return new BigDecimal[] {
      mm(x, origin.x, SPACING.x), mm(y, origin.y, SPACING.y), mm(z, origin.z, SPACING.z)
    };
  }

  private static BigDecimal mm(double coordinate, double origin, double spacing) {
    return new BigDecimal(coordinate)
        .subtract(new BigDecimal(origin))
        .multiply(new BigDecimal(spacing));
  }

  private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
    return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
  }

  @Test
  void aToolThatJumpsBeginsANewPath() {
    BrushPath path = new BrushPath();
    paint(path, new Vec3(2.5, 2.5, 2.5), 0.6, true);
    paint(path, new Vec3(17.5, 17.5, 17.5), 0.6, true);
    assertTrue(bits.get(2, 2, 2));
    assertTrue(bits.get(17, 17, 17));
    assertFalse(bits.get(10, 10, 10));
  }

  @Test
  void nothingIsPaintedBeforeTheToolHasAPlace() {
    place.isPlaced = false;
    paint(new BrushPath(), new Vec3(5, 5, 5), 2, true);
    apply(new ShapeEdit(0, (x, y, z) -> true, 3, true, BrushLimits.NONE));
    assertEquals(0, bits.solidCount());
  }

  @Test
  void aBrushChangesOnlyWhatItsLimitsAllow() {
    BitCube only = new BitCube(EDGE, EDGE, EDGE);
    BitCube kept = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      (n % 3 == 0 ? only : kept).set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    kept.set(9, 9, 9);
    only.set(9, 9, 9);
    for (boolean solid : new boolean[] {true, false}) {
      BitCube before = bits.copy();
      place.device.set(9.5, 9.5, 9.5);
      place.touched.set(9.5, 9.5, 9.5);
      apply(
          BrushEdit.atTool(
              0,
              new BrushPath(),
              3,
              solid,
              new BrushLimits(Optional.of(only), Optional.of(kept), false)));
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int i = n % EDGE;
        int j = n / EDGE % EDGE;
        int k = n / (EDGE * EDGE);
        boolean mayChange = only.get(i, j, k) && !kept.get(i, j, k);
        assertTrue(mayChange || bits.get(i, j, k) == before.get(i, j, k));
      }
      assertTrue(bits.solidCount() != before.solidCount());
    }
  }

  @Test
  void aBrushThatSparesTheToolLeavesTheVoxelsThatItWouldMeet() {
    place.device.set(9.5, 9.5, 9.5);
    place.touched.set(9.5, 9.5, 9.5);
    BrushLimits spares = new BrushLimits(Optional.empty(), Optional.empty(), true);
    apply(BrushEdit.atTool(0, new BrushPath(), 1.3, true, spares));
    assertFalse(bits.get(9, 9, 9));
    assertTrue(bits.get(9, 9, 10));
    bits.set(9, 9, 9);
    apply(BrushEdit.atTool(0, new BrushPath(), 0.1, false, spares));
    assertFalse(bits.get(9, 9, 9)); // erasing is always safe
  }

  @Test
  void editsThatContinueAStrokeAreUndoneWithIt() {
    apply(new VoxelEdit(0, 1, 1, 1, true));
    BrushPath path = new BrushPath();
    for (int n = 0; n < 5; n++) {
      place.device.set(5.5 + n, 9.5, 9.5);
      BrushEdit piece = BrushEdit.atTool(0, path, 0.6, true, BrushLimits.NONE);
      if (n > 0) {
        piece.continueStroke();
      }
      apply(piece);
    }
    BitCube painted = bits.copy();
    assertEquals(2, writer.history().undoable());
    apply(HistoryEdit.undo());
    assertEquals(1, bits.solidCount());
    apply(HistoryEdit.redo());
    assertEquals(painted.solidCount(), bits.solidCount());
    apply(HistoryEdit.undo());
    apply(HistoryEdit.undo());
    assertEquals(0, bits.solidCount());
  }

  @Test
  void anEditContinuesNoStrokeThatAnotherChangeFollowed() {
    BrushPath path = new BrushPath();
    place.device.set(5.5, 9.5, 9.5);
    apply(BrushEdit.atTool(0, path, 0.6, true, BrushLimits.NONE));
    writer.write(0, 0, 0, 0, true); // as a cut does
    writer.history().endStroke();
    place.device.set(6.5, 9.5, 9.5);
    BrushEdit piece = BrushEdit.atTool(0, path, 0.6, true, BrushLimits.NONE);
    piece.continueStroke();
    apply(piece);
    assertEquals(3, writer.history().undoable());
  }

  @Test
  void anEditContinuesNothingAfterAFirstPieceThatChangedNothing() {
    apply(new VoxelEdit(0, 1, 1, 1, true));
    BrushPath path = new BrushPath();
    place.touched.set(9.5, 9.5, 9.5);
    apply(BrushEdit.atTool(0, path, 0.6, false, BrushLimits.NONE));
    place.touched.set(1.5, 1.5, 1.5);
    BrushEdit piece = BrushEdit.atTool(0, path, 0.6, false, BrushLimits.NONE);
    piece.continueStroke();
    apply(piece);
    assertEquals(0, bits.solidCount());
    apply(HistoryEdit.undo());
    assertTrue(bits.get(1, 1, 1));
  }

  @Test
  void aDifferenceIsWrittenAndUndoneToTheBit() {
    for (int run = 0; run < 20; run++) {
      BitCube before = bits.copy();
      BitCube after = bits.copy();
      for (int n = 0; n < 300; n++) {
        int i = random.nextInt(EDGE);
        int j = random.nextInt(EDGE);
        int k = random.nextInt(EDGE);
        if (random.nextBoolean()) {
          after.set(i, j, k);
        } else {
          after.clear(i, j, k);
        }
      }
      apply(new DifferenceEdit(0, before, after, BrushLimits.NONE));
      SameVoxels.require(after, bits, "seed " + Seeds.seed());
      apply(HistoryEdit.undo());
      SameVoxels.require(before, bits, "seed " + Seeds.seed());
      apply(HistoryEdit.redo());
    }
  }

  @Test
  void aDifferenceOfACubeThatIsTooLargeIsRefused() {
    BitCube large = new BitCube(EDGE, EDGE, EDGE + 4);
    BitCube after = large.copy();
    after.set(1, 1, EDGE + 1);
    DifferenceEdit edit = new DifferenceEdit(0, large, after, BrushLimits.NONE);
    assertThrows(IllegalArgumentException.class, () -> queue.offer(edit));
  }

  private void apply(Edit edit) {
    assertTrue(queue.offer(edit));
    while (!edit.isDone()) {
      queue.applyTo(writer, 1 + random.nextInt(700));
    }
  }
}
