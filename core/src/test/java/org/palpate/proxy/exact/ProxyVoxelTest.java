package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** The proxy is in voxel (8, 8, 8) unless a test says otherwise. */
class ProxyVoxelTest {
  private static final int CELL = 8;
  private static final double GAP = GuardedSolver.STOP_SHORT_VOXELS;
  private static final int EDGE = 16;

  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final ProxyVoxel voxel = new ProxyVoxel(true);
  private final Vec3 p = new Vec3(8.5, 8.5, 8.5);
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @ParameterizedTest
  @CsvSource({"0, 1", "0, -1", "1, 1", "1, -1", "2, 1", "2, -1"})
  void theFaceOfASolidStopsAProxyThatHasStoppedBeforeIt(int axis, int direction) {
    solidBeside(axis, direction);
    double face = direction > 0 ? CELL + 1 : CELL;
    p.set(axis, face - direction * GAP);
    voxel.locate(scene, p);
    assertEquals(1 << axis, voxel.facesThatStop(moved(axis, face + direction)));
    assertEquals(1 << axis, voxel.facesThatStop(moved(axis, face)), "ends on the face");
    assertEquals(0, voxel.facesThatStop(moved(axis, face - direction * GAP / 2)), "ends before it");
    assertEquals(0, voxel.facesThatStop(moved(axis, CELL + 0.5 - direction)), "leads away");
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "0, -1", "1, 1", "1, -1", "2, 1", "2, -1"})
  void noFaceStopsAProxyThatIsFartherAwayOrHasNoSolidBesideIt(int axis, int direction) {
    double face = direction > 0 ? CELL + 1 : CELL;
    p.set(axis, face - direction * GAP);
    voxel.locate(scene, p);
    assertEquals(0, voxel.facesThatStop(moved(axis, face + direction)), "no solid");
    solidBeside(axis, direction);
    voxel.forget();
    p.set(axis, face - direction * 2 * GAP);
    voxel.locate(scene, p);
    assertEquals(0, voxel.facesThatStop(moved(axis, face + direction)), "farther away");
  }

  /** Behind the open face the segment is in another voxel, whose faces are others. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0, 2", "1, 0", "1, 2", "2, 0", "2, 1"})
  void aFaceThatIsCrossedAfterAnOpenOneDoesNotStop(int stopped, int open) {
    for (int direction : new int[] {1, -1}) {
      double openFace = direction > 0 ? CELL + 1 : CELL;
      p.set(8.5, 8.5, 8.5);
      p.set(stopped, CELL + 1 - GAP);
      p.set(open, openFace - direction * GAP / 8);
      solidBeside(stopped, 1);
      voxel.locate(scene, p);
      Vec3 to = new Vec3().set(p);
      to.set(stopped, p.get(stopped) + 0.25);
      to.set(open, p.get(open) + direction * 0.25);
      assertEquals(0, voxel.facesThatStop(to), "both as fast: the open face comes first");
      to.set(stopped, CELL + 1);
      to.set(open, p.get(open) + direction * GAP / 16);
      assertEquals(1 << stopped, voxel.facesThatStop(to), "ends before the open face");
      to.set(open, p.get(open));
      assertEquals(1 << stopped, voxel.facesThatStop(to), "does not move towards the open face");
      p.set(open, 8.5);
      voxel.locate(scene, p);
      to.set(stopped, CELL + 2);
      to.set(open, 8.5 + direction * 2);
      assertEquals(1 << stopped, voxel.facesThatStop(to), "the open face is far away");
    }
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void aSegmentAlongAnAxisIsARowUnlessItRunsWithinAPlane(int axis) {
    voxel.locate(scene, p);
    assertEquals(axis, voxel.axisOfRow(moved(axis, 12)));
    int other = (axis + 1) % 3;
    Vec3 oblique = moved(axis, 12);
    oblique.set(other, 9);
    assertEquals(ProxyVoxel.NO_ROW, voxel.axisOfRow(oblique));
    p.set(axis, CELL);
    voxel.locate(scene, p);
    assertEquals(axis, voxel.axisOfRow(moved(axis, 12)), "starts on a plane across the row");
    for (int beside : new int[] {other, (axis + 2) % 3}) {
      p.set(8.5, 8.5, 8.5);
      p.set(beside, CELL);
      voxel.locate(scene, p);
      assertEquals(ProxyVoxel.NO_ROW, voxel.axisOfRow(moved(axis, 12)), "within a plane");
    }
  }

  @Test
  void aRowMeetsTheVoxelThatTheExactCasterFinds() {
    ExactRayCaster caster = new ExactRayCaster();
    RayHit hit = new RayHit();
    RayHit expected = new RayHit();
    int hits = 0;
    for (int n = 0; n < RandomCases.of(20_000); n++) {
      bits.set(random.nextInt(EDGE), random.nextInt(EDGE), random.nextInt(EDGE));
      bits.clear(random.nextInt(EDGE), random.nextInt(EDGE), random.nextInt(EDGE));
      int axis = random.nextInt(3);
      p.set(inCell(), inCell(), inCell());
      if (scene.touches(p.x, p.y, p.z)) {
        continue;
      }
      voxel.forget();
      voxel.locate(scene, p);
      double end = random.nextInt(-2, EDGE + 2) + random.nextInt(3) / 2.0;
      Vec3 to = moved(axis, end);
      String what = "seed=" + Seeds.seed() + " from " + p + " to " + to;
      boolean found = scene.cast(caster, ray(to), expected);
      assertEquals(found, voxel.castRow(axis, end, hit), what);
      if (found) {
        hits++;
        assertEquals(cellOf(expected), cellOf(hit), what);
        assertEquals(axis, hit.axis, what);
        assertEquals(expected.t, hit.t, 1e-13, what);
      }
    }
    assertTrue(hits > RandomCases.of(1000), "too few hits to mean anything: " + hits);
  }

  /** Returns a coordinate in a cell, on none of its planes. */
  private double inCell() {
    return random.nextInt(EDGE) + 0.25 + random.nextInt(3) / 4.0;
  }

  private Ray ray(Vec3 to) {
    return new Ray().from(p.x, p.y, p.z).to(to.x, to.y, to.z);
  }

  private static List<Integer> cellOf(RayHit hit) {
    return List.of(hit.i, hit.j, hit.k);
  }

  @Test
  void aStepIsOpenIfItsTopIsEmptyAndSoIsAVoxelBesideTheTopTowardsTheDevice() {
    int open = 0;
    int cases = RandomCases.of(20_000);
    for (int n = 0; n < cases; n++) {
      for (int voxels = 0; voxels < 27; voxels++) {
        put(voxels % 3 - 1, voxels / 3 % 3 - 1, voxels / 9 - 1, random.nextInt(3) != 0);
      }
      Vec3 device =
          new Vec3(
              8.5 + random.nextInt(-1, 2),
              8.5 + random.nextInt(-1, 2),
              8.5 + random.nextInt(-1, 2));
      voxel.forget();
      voxel.locate(scene, p);
      int axis = random.nextInt(3);
      int direction = random.nextBoolean() ? 1 : -1;
      boolean expected = isStepOpen(axis, direction, device);
      open += expected ? 1 : 0;
      assertEquals(
          expected,
          voxel.isStepOpen(axis, direction, device),
          "seed=" + Seeds.seed() + " axis " + axis + " direction " + direction + " to " + device);
    }
    assertTrue(open > cases / 20, "too few open steps to mean anything: " + open);
  }

  /** The definition, voxel by voxel. */
  private boolean isStepOpen(int axis, int direction, Vec3 device) {
    Vec3 top = moved(axis, 8.5 + direction);
    boolean open = false;
    for (int along = 0; along < 3; along++) {
      double towards = Math.signum(device.get(along) - p.get(along));
      if (along != axis && towards != 0) {
        Vec3 beside = new Vec3().set(top);
        beside.set(along, top.get(along) + towards);
        open |= !isSolidAt(beside);
      }
    }
    return open && !isSolidAt(top);
  }

  private boolean isSolidAt(Vec3 at) {
    return bits.get((int) at.x, (int) at.y, (int) at.z);
  }

  private void put(int x, int y, int z, boolean solid) {
    if (solid) {
      bits.set(CELL + x, CELL + y, CELL + z);
    } else {
      bits.clear(CELL + x, CELL + y, CELL + z);
    }
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void aSegmentStaysInTheVoxelIfItEndsBetweenItsFacesOrDoesNotMove(int axis) {
    voxel.locate(scene, p);
    assertTrue(voxel.contains(moved(axis, Math.nextUp(8.0))));
    assertTrue(voxel.contains(moved(axis, Math.nextDown(9.0))));
    assertFalse(voxel.contains(moved(axis, 8)));
    assertFalse(voxel.contains(moved(axis, 9)));
    assertFalse(voxel.contains(moved(axis, 3)));
    p.set(axis, CELL);
    assertTrue(voxel.contains(p), "stays on the plane");
  }

  @Test
  void locatesTheVoxelByRoundingDown() {
    p.set(-0.5, 3, Math.nextDown(7.0));
    voxel.locate(scene, p);
    assertTrue(voxel.isCell(-1, 3, 6));
    assertFalse(voxel.isCell(0, 3, 6) || voxel.isCell(-1, 2, 6) || voxel.isCell(-1, 3, 7));
    assertEquals(List.of(-1, 3, 6), List.of(voxel.cell(0), voxel.cell(1), voxel.cell(2)));
  }

  @Test
  void anotherSceneIsRead() {
    BitCube full = new BitCube(EDGE, EDGE, EDGE);
    full.set(9, 8, 8);
    p.x = 9 - GAP;
    voxel.locate(scene, p);
    assertEquals(0, voxel.facesThatStop(moved(0, 10)));
    voxel.locate(new CollisionScene(List.of(full)), p);
    assertEquals(1, voxel.facesThatStop(moved(0, 10)));
    voxel.locate(scene, p);
    assertEquals(0, voxel.facesThatStop(moved(0, 10)));
  }

  @Test
  void aChangedVoxelIsSeenAfterForgetOrIfNothingIsKept() {
    ProxyVoxel keepsNothing = new ProxyVoxel(false);
    p.x = 9 - GAP;
    voxel.locate(scene, p);
    keepsNothing.locate(scene, p);
    Vec3 to = moved(0, 10);
    assertEquals(0, voxel.facesThatStop(to) | keepsNothing.facesThatStop(to));
    solidBeside(0, 1);
    voxel.forget();
    voxel.locate(scene, p);
    assertEquals(1, voxel.facesThatStop(to));
    keepsNothing.locate(scene, p);
    assertEquals(1, keepsNothing.facesThatStop(to));
    assertEquals(0, keepsNothing.knownNeighbourhoods());
  }

  private void solidBeside(int axis, int direction) {
    put(axis == 0 ? direction : 0, axis == 1 ? direction : 0, axis == 2 ? direction : 0, true);
  }

  private Vec3 moved(int axis, double to) {
    Vec3 end = new Vec3().set(p);
    end.set(axis, to);
    return end;
  }
}
