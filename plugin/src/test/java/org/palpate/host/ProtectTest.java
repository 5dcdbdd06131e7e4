package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.BodyScene;
import org.palpate.device.Trajectory;
import org.palpate.force.FeelSettings;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.force.guide.NearestApproach;
import org.palpate.force.guide.SegmentDistance;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.tool.MadeTool;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Drills bone around a nerve that is protected, with hostile hands. */
class ProtectTest {
  private static final int EDGE = 28;
  private static final double MARGIN_MM = 1.5;
  private static final double ROUNDING_MM = 1e-9;
  private static final long SEED = 20261128;

  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
  private final BitCube bone = new BitCube(EDGE, EDGE, EDGE);
  private final BitCube nerve = new BitCube(EDGE, EDGE, EDGE);

  ProtectTest() {
    for (int k = 4; k < 20; k++) {
      for (int j = 2; j < EDGE - 2; j++) {
        for (int i = 2; i < EDGE - 2; i++) {
          boolean inNerve = Math.abs(i - 14) < 2 && Math.abs(k - 12) < 2;
          (inNerve ? nerve : bone).set(i, j, k);
        }
      }
    }
  }

  private ContactScene scene() {
    List<Segment> segments =
        List.of(new Segment("bone", bone, 0xffffff), new Segment("nerve", nerve, 0xffff00));
    return new ContactScene(
        new SegmentedVolume(grid, segments),
        ContactSettings.builder(SolverKind.GUARDED)
            .carve(OptionalDouble.of(500))
            .protect(Map.of("nerve", MARGIN_MM))
            .build());
  }

  /** Returns a hand that starts above the bone, wanders through it and jumps now and then. */
  private static Trajectory hand(int frames) {
    SplittableRandom random = new SplittableRandom(SEED);
    Trajectory trajectory = new Trajectory();
    Vec3 at = new Vec3(14, 14, 25);
    Vec3 to = new Vec3(14, 14, 0);
    for (int n = 0; n < frames; n++) {
      if (n % 150 == 149) {
        to.set(random.nextDouble(EDGE), random.nextDouble(EDGE), random.nextDouble(EDGE));
      }
      Vec3 way = to.sub(at, new Vec3());
      at.add(way.mul(random.nextInt(400) == 0 ? 1 : 0.02, way), at);
      trajectory.add(n, at.x, at.y, at.z);
    }
    return trajectory;
  }

  @ParameterizedTest
  @ValueSource(strings = {"body", "points"})
  void aBurrStopsAtTheMarginAndNothingInItIsRemoved(String clearance) throws IOException {
    BitCube before = bone.copy();
    ContactScene contact = scene();
    MadeTool made =
        ToolMaker.make(
            ToolRequest.parse("sphere:2", null, null, clearance), 1, CoordinateSystem.UNKNOWN);
    BodyScene bodies = contact.newBodies();
    List<org.palpate.rigid.Clearance> clearances =
        made.clearances(bodies, contact.settings().protectedMm());
    ToolScene tools =
        new ToolScene(contact, bodies, made.tool(), clearances, OptionalDouble.empty());
    double[] nearest = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    new ToolReplay(tools, hand(20_000), false)
        .run(
            (number, frame) -> {
              assertEquals(0, frame.motion().reducedPoints());
              nearest[0] = Math.min(nearest[0], distance(frame.motion().pose().translation));
              if (distance(frame.motion().pose().translation) < nearest[1] + 2.5) {
                nearest[1] = Math.min(nearest[1], nearestPoint(made.tool(), frame));
              }
            });
    assertReported(nearest[1], contact);
    double gapMm = nearest[0] - 2;
    // in mode points the sphere bulges between its points
    double bulgeMm = clearance.equals("body") ? 0 : made.tool().coverRadiusMm();
    assertTrue(gapMm >= MARGIN_MM - bulgeMm - ROUNDING_MM, "gap " + gapMm);
    assertTrue(gapMm < MARGIN_MM + 2, "the burr came near: gap " + gapMm);
    assertKept(before);
  }

  @Test
  void aPointStopsAtTheMarginAndNothingInItIsRemoved() throws IOException {
    BitCube before = bone.copy();
    double[] nearest = {Double.POSITIVE_INFINITY};
    ContactScene contact = scene();
    ReplayRun.inWorld(contact, hand(20_000))
        .run(
            (number, device, point, force, state, freed) ->
                nearest[0] = Math.min(nearest[0], distance(point)));
    assertTrue(nearest[0] >= MARGIN_MM - ROUNDING_MM, "nearest " + nearest[0]);
    assertTrue(nearest[0] < MARGIN_MM + 1, "the point came near: " + nearest[0]);
    assertReported(nearest[0], contact);
    assertKept(before);
  }

  /** The frame is found by interpolation, so it may be one that is a little farther. */
  private static void assertReported(double nearestMm, ContactScene contact) {
    NearestApproach approach = contact.approaches().get(0);
    assertEquals("nerve", approach.segment());
    double reportedMm = approach.nearestMm().getAsDouble();
    assertTrue(reportedMm >= nearestMm - ROUNDING_MM, reportedMm + " of " + nearestMm);
    assertTrue(reportedMm <= nearestMm + 0.2, reportedMm + " of " + nearestMm);
    assertTrue(approach.frame() > 0 && approach.frame() < 20_000);
  }

  private double nearestPoint(RigidTool tool, ToolFrame frame) {
    double least = Double.POSITIVE_INFINITY;
    Vec3 p = new Vec3();
    for (int n = 0; n < tool.count(); n++) {
      frame.motion().pose().transform(tool.point(n, p), p);
      least = Math.min(least, distance(p));
    }
    return least;
  }

  /** The hand hovers beside the bone; the force of the guidance is the only one. */
  @Test
  void aToolNearTheMarginIsPushedAway() throws IOException {
    SegmentDistance distances = new SegmentDistance(nerve, grid, MARGIN_MM + 2);
    List<Segment> segments = List.of(new Segment("nerve", nerve, 0xffff00));
    ContactScene contact =
        new ContactScene(
            new SegmentedVolume(grid, segments),
            ContactSettings.builder(SolverKind.GUARDED)
                .protect(Map.of("nerve", MARGIN_MM))
                .feel(
                    new FeelSettings(
                        List.of(Guides.away(distances, MARGIN_MM + 2, GuideStrength.STANDARD)),
                        Optional.empty(),
                        Optional.empty()))
                .build());
    Trajectory down = new Trajectory();
    for (int n = 0; n < 2000; n++) {
      down.add(n, 14.5, 14.5, 25 - n * 0.0045); // to a height of 16, and the nerve ends at 14
    }
    double[] last = {0};
    ReplayRun.inWorld(contact, down)
        .run(
            (number, device, point, force, state, freed) -> {
              if (point.z > 14 + MARGIN_MM + 2.5) {
                assertEquals(0, force.length(), 1e-9);
              } else if (point.z < 14 + MARGIN_MM + 1.5) {
                assertTrue(force.z > 0 && force.z >= last[0] - 1e-3, "force " + force);
                last[0] = force.z;
              }
            });
    assertTrue(last[0] > 0.2, "force " + last[0]);
  }

  private void assertKept(BitCube before) {
    long removed = 0;
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      if (before.get(i, j, k) && !bone.get(i, j, k)) {
        removed++;
        assertTrue(voxelDistance(i, j, k) >= MARGIN_MM, "voxel " + i + "," + j + "," + k);
      }
    }
    assertTrue(removed > 100, "removed " + removed);
    assertEquals(9 * (EDGE - 4), nerve.solidCount());
  }

  /** Returns the distance of a point from the nearest voxel of the nerve. */
  private double distance(Vec3 p) {
    double least = Double.POSITIVE_INFINITY;
    for (int j = 2; j < EDGE - 2; j++) {
      for (int k = 11; k <= 13; k++) {
        for (int i = 13; i <= 15; i++) {
          double x = outside(p.x, i);
          double y = outside(p.y, j);
          double z = outside(p.z, k);
          least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
        }
      }
    }
    return least;
  }

  private static double outside(double coordinate, int voxel) {
    return Math.max(0, Math.max(voxel - coordinate, coordinate - (voxel + 1)));
  }

  /** Returns the distance of a voxel from the nearest voxel of the nerve. */
  private static double voxelDistance(int i, int j, int k) {
    double x = Math.max(0, Math.max(13 - (i + 1), i - 16));
    double y = Math.max(0, Math.max(2 - (j + 1), j - (EDGE - 2)));
    double z = Math.max(0, Math.max(11 - (k + 1), k - 14));
    return Math.sqrt(x * x + y * y + z * z);
  }
}
