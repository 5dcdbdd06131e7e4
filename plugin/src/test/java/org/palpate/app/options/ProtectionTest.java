package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class ProtectionTest {
  @ParameterizedTest
  @CsvSource({
    "nerve, nerve, 0, 0",
    "nerve:1.5, nerve, 1.5, 1.5",
    "nerve:1.5:4, nerve, 1.5, 4",
    "nerve:1.5:0, nerve, 1.5, 0",
    "left:nerve:2, left:nerve, 2, 2",
    "left:nerve:2:3, left:nerve, 2, 3",
    "v1:2:3:4, v1:2, 3, 4"
  })
  void lengthsStandBehindTheLastColons(String text, String name, double margin, double guide) {
    assertEquals(List.of(new Protection(name, margin, guide)), Protection.all(List.of(text)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", ":2", "nerve:", "nerve:x", "nerve:-1", "nerve:1000.5", "n:1:1001"})
  void aLengthMustBeANumberFromZeroToAMetre(String text) {
    Given.refuses(
        "the margin cannot be read: --protect "
            + text
            + ": write NAME, NAME:MM or NAME:MM:MM with lengths from 0 to 1,000 mm, as in"
            + " nerve:1.5",
        () -> Protection.all(List.of("fine:1", text)));
  }

  @Test
  void thePushBeginsOutsideTheMarginAndLeadsAway() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(16, 16, 16);
    Protection protection = new Protection("nerve", 2, 3);
    HapticEffect push =
        protection
            .guidance(oneVoxel(grid, 8))
            .orElseThrow()
            .make(new EffectSite(RigidTransform.identity(), 0.5, 0, 10, List.of(new Vec3())));
    assertEquals(0, pushAt(push, 8.5 + 5.6).length(), "beyond margin and guidance");
    Vec3 near = pushAt(push, 8.5 + 4);
    assertTrue(near.x > 0.1 && near.y == 0 && near.z == 0, near.toString());
    assertTrue(pushAt(push, 8.5 + 3).x > near.x, "it grows towards the segment");
    assertTrue(new Protection("nerve", 2, 0).guidance(oneVoxel(grid, 8)).isEmpty());
  }

  private static Vec3 pushAt(HapticEffect push, double x) {
    HandState hand = new HandState();
    hand.device.translation.set(x, 8.5, 8.5);
    hand.tool.translation.set(x, 8.5, 8.5);
    push.reset();
    Vec3 force = new Vec3();
    push.add(hand, force, new Vec3());
    return force;
  }

  private static SegmentedVolume oneVoxel(VoxelGrid grid, int at) {
    BitCube bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    bits.set(at, at, at);
    return new SegmentedVolume(grid, List.of(new Segment("nerve", bits, 0xFFFFFF)));
  }

  @Test
  void aSegmentWithTooManyVoxelsAroundItHasNoPush() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(16, 16, 16);
    Given.refuses(
        "the segment is too large for a guidance force: --protect nerve: end it with :0, as in"
            + " nerve:1:0",
        () -> new Protection("nerve", 60, 200).guidance(oneVoxel(grid, 8)));
  }
}
