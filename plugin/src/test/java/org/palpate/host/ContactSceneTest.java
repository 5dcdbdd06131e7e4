package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.carve.CarveSettings;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class ContactSceneTest {
  private static final int SIZE = 16;
  private static final DeviceSpecification DEVICE =
      new DeviceSpecification("test", "", 3, 0.8, 80, 1_000_000);

  private final SegmentedVolume volume = volume(1);

  /** Returns two boxes in voxels of 1 x 1 x depth mm: "bone" below, "skin" above. */
  private static SegmentedVolume volume(double depthMm) {
    VoxelGrid grid =
        new VoxelGrid(SIZE, SIZE, SIZE, new Vec3(1, 1, depthMm), RigidTransform.identity());
    return new SegmentedVolume(grid, List.of(box("bone", 2, 5), box("skin", 6, 9)));
  }

  private static Segment box(String name, int lowK, int highK) {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int k = lowK; k <= highK; k++) {
      for (int n = 0; n < 64; n++) {
        bits.set(4 + n % 8, 4 + n / 8, k);
      }
    }
    return new Segment(name, bits, 0);
  }

  private ContactScene scene(ContactSettings.Builder settings) {
    return new ContactScene(volume, settings.build());
  }

  private static ContactSettings.Builder settings() {
    return ContactSettings.builder(SolverKind.SMOOTH);
  }

  @ParameterizedTest
  @EnumSource(SolverKind.class)
  void eachKindHasItsSolver(SolverKind kind) {
    Class<?> expected =
        switch (kind) {
          case DOT -> DotSolver.class;
          case PAPER -> PaperSolver.class;
          case GUARDED -> GuardedSolver.class;
          case SMOOTH -> SmoothSolver.class;
          case NONE -> CollisionOnlySolver.class;
        };
    ContactScene scene = scene(ContactSettings.builder(kind));
    ProxySolver first = scene.newSolver();
    assertInstanceOf(expected, first);
    assertNotSame(first, scene.newSolver());
    assertInstanceOf(expected, scene(settings()).newSolver(kind));
  }

  @Test
  void theLongestStepIsThatOfTheSettingsOrOfTheVoxels() {
    assertEquals(8, scene(settings()).maxStepMm());
    assertEquals(15, new ContactScene(volume(5), settings().build()).maxStepMm());
    assertEquals(2.5, scene(settings().maxStep(OptionalDouble.of(2.5))).maxStepMm());
  }

  @Test
  void eachSegmentIsAnObjectAndTheMarginsAreTheLast() {
    CollisionScene plain = scene(settings()).newCollisionScene();
    assertSame(volume.segments().get(1).bits(), plain.cube(1));
    assertThrows(IndexOutOfBoundsException.class, () -> plain.cube(2));
    ContactScene guarded = scene(settings().protect(Map.of("bone", 1.0)));
    CollisionScene objects = guarded.newCollisionScene();
    assertSame(guarded.protectedVoxels().orElseThrow(), objects.cube(2));
    assertTrue(objects.touches(8.5, 8.5, 1.5), "within the margin of 1 mm");
    assertTrue(!objects.touches(8.5, 8.5, 0.5), "outside it");
    BitCube kept = guarded.protectedVoxels().orElseThrow();
    assertTrue(kept.get(8, 8, 3) && kept.get(8, 8, 6) && !kept.get(8, 8, 7));
    assertEquals(Optional.empty(), scene(settings()).protectedVoxels());
  }

  @Test
  void materialsFollowTheOrderOfTheSegments() {
    ForceSettings plain = scene(settings().friction(0.3)).force(0.7);
    assertEquals(0.7, plain.stiffnessNewtonPerMm());
    assertEquals(0.3, plain.friction());
    assertEquals(List.of(), plain.materials());
    MaterialOverride soft = MaterialOverride.parse("stiffness:0.1").orElseThrow();
    ForceSettings two = scene(settings().stiffness(0.9).materials(Map.of("skin", soft))).force(0.7);
    assertEquals(0.9, two.stiffnessNewtonPerMm(), "the settings count before the device");
    assertEquals(2, two.materials().size());
    assertEquals(0.9, two.materials().get(0).stiffnessNewtonPerMm());
    assertEquals(0.1, two.materials().get(1).stiffnessNewtonPerMm());
    ForceSettings guarded =
        scene(settings().protect(Map.of("bone", 1.0)).materials(Map.of("skin", soft))).force(0.7);
    assertEquals(3, guarded.materials().size(), "the margins have a material too");
    assertEquals(0.7, guarded.materials().get(2).stiffnessNewtonPerMm());
  }

  @Test
  void theLargestForceIsThatOfTheDeviceUnlessItIsGiven() {
    assertEquals(3, scene(settings()).liveFrame(DEVICE, 0.5).maxForceNewton());
    assertEquals(
        1.5,
        scene(settings().maxForce(OptionalDouble.of(1.5))).liveFrame(DEVICE, 0.5).maxForceNewton());
  }

  @Test
  void aSceneCutsOnlyIfItsSettingsSaySo() {
    assertEquals(Optional.empty(), scene(settings()).carve());
    MaterialOverride hard = MaterialOverride.parse("cut:0.5").orElseThrow();
    CarveSettings cuts =
        scene(
                settings()
                    .carve(OptionalDouble.of(7))
                    .materials(Map.of("skin", hard))
                    .protect(Map.of("bone", 0.0)))
            .carve()
            .orElseThrow();
    assertEquals(7, cuts.rateMm3PerNewtonSecond());
    assertEquals(List.of(0.0, 0.5), cuts.leastNewtons());
  }

  @Test
  void bodiesStandWhereTheirPlacementsSay() {
    Pose moved = new Pose();
    moved.translation.set(3, 0, 0);
    ContactScene placed =
        new ContactScene(
            volume,
            List.of(
                new Placement(Mobility.FIXED, new Pose()), new Placement(Mobility.MOVABLE, moved)),
            ContactSettings.standard(),
            Optional.empty());
    BodyScene bodies = placed.newBodies();
    assertEquals(Mobility.FIXED, bodies.body(0).mobility());
    assertEquals(Mobility.MOVABLE, bodies.body(1).mobility());
    assertEquals(3, bodies.body(1).pose().translation.x);
    assertSame(volume.segments().get(1).bits(), bodies.body(1).bits());
    assertEquals(Mobility.MOVABLE, placed.newBodies(Set.of(0)).body(0).mobility());
    BodyScene atRest = scene(settings()).newBodies(Set.of(1));
    assertEquals(Mobility.FIXED, atRest.body(0).mobility());
    assertEquals(Mobility.MOVABLE, atRest.body(1).mobility());
    assertEquals(15, placed.handTarget().highMm().x, 1e-9, "the hand finds the moved body");
    assertEquals(12, scene(settings()).handTarget().highMm().x, 1e-9);
  }

  @Test
  void greyValuesAreQueuedOnlyIfThereAreAny() {
    IllegalStateException refusal =
        assertThrows(IllegalStateException.class, () -> scene(settings()).offerGrey(surface(500)));
    assertEquals(
        "the scene has no grey values; create it with a GreyIsosurface", refusal.getMessage());
    GreyIsosurface first = surface(500);
    ContactScene grey = new ContactScene(volume, ContactSettings.standard(), Optional.of(first));
    assertSame(first, grey.grey().orElseThrow());
    assertTrue(grey.offerGrey(surface(600)));
    assertSame(first, grey.grey().orElseThrow(), "the haptic thread takes it later");
    assertTrue(!grey.edits().isIdle());
  }

  private GreyIsosurface surface(double threshold) {
    ScalarVolume values = ScalarVolume.of(volume.grid(), ScalarVolume.Storage.INT16);
    for (int n = 0; n < SIZE * SIZE * SIZE; n++) {
      values.set(n % SIZE, n / SIZE % SIZE, n / SIZE / SIZE, 100 * (n / SIZE / SIZE));
    }
    return GreyIsosurface.ofThreshold(values, threshold);
  }

  @Test
  void aHandPressesTheSurfaceOfAllSegments() {
    HandTarget target = HandTargetFinder.of(volume(2));
    assertEquals("(4.0, 4.0, 4.0)", target.lowMm().toString());
    assertEquals("(12.0, 12.0, 20.0)", target.highMm().toString());
    assertEquals(1, target.voxelMm());
    assertEquals(512, target.surfaceMm().size(), "from every direction");
    for (Vec3 point : target.surfaceMm()) {
      double out =
          Math.max(
              Math.abs(point.x - 8) / 4,
              Math.max(Math.abs(point.y - 8) / 4, Math.abs(point.z - 12) / 8));
      assertEquals(1, out, 1e-9, "on a face of the box: " + point);
    }
    SegmentedVolume empty =
        new SegmentedVolume(
            volume.grid(), List.of(new Segment("none", new BitCube(SIZE, SIZE, SIZE), 0)));
    assertEquals("(16.0, 16.0, 16.0)", HandTargetFinder.of(empty).highMm().toString());
    assertEquals(List.of(), HandTargetFinder.of(empty).surfaceMm());
  }
}
