package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;
import org.palpate.volume.VoxelGrid;

/** The place of a capsule over a floor whose voxels are 0.5 x 1 x 2 mm, in a turned grid. */
class RigidPlaceTest {
  /** Grid axis x runs along world y, y along -x and z along z. */
  private static final RigidTransform TURNED =
      new RigidTransform(
          new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(10, 20, 30));

  private static final VoxelGrid GRID = new VoxelGrid(32, 32, 32, new Vec3(0.5, 1, 2), TURNED);

  private final Body floor = new Body("floor", Floor.bits(), GRID, Mobility.FIXED);
  private final BodyScene bodies = new BodyScene(List.of(floor));
  private final RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 4), 0.498);
  private final RigidSolver solver =
      new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(5, bodies, tool));
  private final ToolMotion motion = solver.newMotion();
  private final Pose device = new Pose();
  private final RigidPlace place =
      new RigidPlace(bodies, solver.newBlockingVoxels(), motion, device);
  private final Vec3 p = new Vec3(1, 2, 3);
  private final AffineMap map = new AffineMap();

  RigidPlaceTest() {
    device.translation.set(-5, 28, 60);
    device.rotation.setRotationVector(new Vec3(0.3, -0.2, 0.5));
  }

  @Test
  void aToolThatNoSampleHasPlacedHasNoPlace() {
    assertFalse(place.isPlaced());
    assertFalse(place.touchedPoint(0, p));
    assertFalse(place.devicePosition(0, p));
    assertFalse(place.gridToDevice(0, map));
    assertFalse(place.meets(0, 16, 16, 4));
    assertTrue(p.sameBits(new Vec3(1, 2, 3)));
  }

  @Test
  void aToolWithoutContactActsAtItsReferencePoint() {
    placeTool();
    assertTrue(place.isPlaced());
    assertTrue(place.touchedPoint(0, p));
    assertSameWorldPoint(motion.pose().translation, p);
    assertTrue(place.devicePosition(0, p));
    assertSameWorldPoint(device.translation, p);
  }

  private void placeTool() {
    assertTrue(solver.place(device, motion));
    place.place();
  }

  private static void assertSameWorldPoint(Vec3 worldMm, Vec3 grid) {
    Vec3 back = GRID.gridToWorld(new AffineMap()).transform(grid, new Vec3());
    assertEquals(0, back.sub(worldMm, new Vec3()).length(), 1e-12, grid + " for " + worldMm);
  }

  @Test
  void aToolInContactActsWhereItTouches() {
    placeTool();
    device.translation.z = 44; // the surface lies at 46
    for (int n = 0; n < 20; n++) {
      solver.follow(device, motion);
    }
    assertTrue(motion.contact());
    assertTrue(place.touchedPoint(0, p));
    assertSameWorldPoint(motion.contactMm(0, new Vec3()), p);
    assertEquals(Floor.TOP, p.z, 0.5, "grid coordinates of the surface");
    assertTrue(place.devicePosition(0, p));
    assertSameWorldPoint(device.translation, p);
  }

  @Test
  void theMapLeadsFromTheGridOfABodyToTheFrameOfTheDevice() {
    placeTool();
    assertTrue(place.gridToDevice(0, map));
    for (Vec3 grid : List.of(new Vec3(), new Vec3(3, -7, 11), new Vec3(31, 2.5, 0.25))) {
      Vec3 world = GRID.gridToWorld(new AffineMap()).transform(grid, new Vec3());
      Vec3 expected = device.inverseTransform(world, new Vec3());
      Vec3 actual = map.transform(grid, new Vec3());
      assertEquals(0, actual.sub(expected, new Vec3()).length(), 1e-12);
    }
  }

  @Test
  void aVoxelAtTheToolMeetsItAndOneFarAwayDoesNot() {
    placeTool();
    assertTrue(place.touchedPoint(0, p));
    int i = (int) Math.floor(p.x);
    int j = (int) Math.floor(p.y);
    int k = (int) Math.floor(p.z);
    assertTrue(place.meets(0, i, j, k));
    assertFalse(place.meets(0, i, j, k - 5));
  }
}
