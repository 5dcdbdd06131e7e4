package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class BodyTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  private static final VoxelGrid OBLIQUE =
      new VoxelGrid(
          8,
          9,
          10,
          new Vec3(1, 0.5, 5),
          new RigidTransform(
              new Vec3(0, 0.6, 0.8),
              new Vec3(1, 0, 0),
              new Vec3(0, 0.8, -0.6),
              new Vec3(5, -6, 70)));

  @Test
  void mapsToolPointsByItsPoseAndItsGrid() {
    Body body = new Body("b", new BitCube(8, 9, 10), OBLIQUE, Mobility.MOVABLE);
    for (int n = 0; n < 300; n++) {
      Pose tool = RandomGeometry.pose(random, 50);
      Pose pose = RandomGeometry.pose(random, 50);
      body.setPose(pose);
      Vec3 p = RandomGeometry.vector(random, 10);
      Vec3 rest = pose.inverseTransform(tool.transform(p, new Vec3()), new Vec3());
      Vec3 expected = OBLIQUE.worldToGrid(rest, new Vec3());
      Vec3 actual = body.toolToGrid(tool, new AffineMap()).transform(p, new Vec3());
      assertEquals(0, expected.sub(actual, new Vec3()).length(), 1e-9);
    }
  }

  @Test
  void directionsOfTheGridTurnWithTheBody() {
    Body body = new Body("b", new BitCube(8, 9, 10), OBLIQUE, Mobility.MOVABLE);
    Pose pose = RandomGeometry.pose(random, 50);
    body.setPose(pose);
    Vec3 a = OBLIQUE.gridToWorld(new Vec3(1, 2, 3), new Vec3());
    Vec3 b = OBLIQUE.gridToWorld(new Vec3(2, 4, 5), new Vec3());
    Vec3 expected = pose.transform(b, b).sub(pose.transform(a, a), new Vec3());
    Vec3 actual = body.gridDirectionToWorld(new Vec3(1, 1, 10), new Vec3());
    assertEquals(0, expected.sub(actual, new Vec3()).length(), 1e-9);
  }

  @Test
  void remembersWhatEditsChanged() {
    BitCube bits = new BitCube(8, 9, 10);
    Body body = new Body("b", bits, OBLIQUE, Mobility.FIXED);
    for (int n = 0; n < 200; n++) {
      IntBox box = new IntBox();
      box.include(n % 8, n % 9, n % 10);
      bits.set(n % 8, n % 9, n % 10);
      body.voxelsChanged(box);
    }
    assertEquals(200, body.edits());
    assertTrue(body.change(199).contains(7, 1, 9));
    assertTrue(body.change(0).contains(7, 8, 9), "long past: everything");
    assertEquals(0, body.clearance().at(3.5, 0.5, 9.5));
  }

  @Test
  void aSceneKnowsItsShortestEdge() {
    Body coarse =
        new Body("a", new BitCube(2, 2, 2), VoxelGrid.ofUnitVoxels(2, 2, 2), Mobility.FIXED);
    Body fine = new Body("b", new BitCube(8, 9, 10), OBLIQUE, Mobility.FIXED);
    assertEquals(0.5, new BodyScene(List.of(coarse, fine)).shortestEdgeMm());
  }
}
