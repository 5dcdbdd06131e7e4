package org.palpate.host.placing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyGroups;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Reads a bar that is cut in three by gaps of two voxels. */
class HeldReadingsTest {
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(60, 12, 12);

  private final SegmentedVolume bar =
      new SegmentedVolume(
          GRID,
          List.of(
              new Segment("left", part(0, 24), 0),
              new Segment("middle", part(26, 40), 0),
              new Segment("right", part(42, 56), 0)));

  private final List<Pose> starts = List.of(new Pose(), new Pose(), new Pose());

  private static BitCube part(int from, int to) {
    BitCube bits = new BitCube(60, 12, 12);
    for (int n = 0; n < 100 * (to - from); n++) {
      bits.set(from + n / 100, 1 + n % 10, 1 + n / 10 % 10);
    }
    return bits;
  }

  private static List<RigidTransform> transforms(Pose... poses) {
    List<RigidTransform> transforms = new ArrayList<>();
    for (Pose pose : poses) {
      transforms.add(pose.transform(RigidTransform.identity()));
    }
    return transforms;
  }

  private static Pose moved(double x, double turn) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(turn, 0, 0));
    // Keeps the bar's own axis, which runs through (y, z) = (6, 6).
    Vec3 axis = new Vec3(0, 6, 6);
    axis.sub(pose.rotation.rotate(axis, new Vec3()), pose.translation);
    pose.translation.x = x;
    return pose;
  }

  @Test
  void aFragmentIsReadAgainstItsNeighboursAndItsStart() {
    HeldReadings readings = new HeldReadings(bar, starts, Optional.empty());
    Pose middle = moved(0.5, Math.toRadians(10));
    List<String> lines =
        readings.lines(1, transforms(new Pose(), middle, new Pose()), BodyGroups.none(3));
    assertEquals(3, lines.size(), lines.toString());
    assertTrue(lines.get(0).startsWith("middle to left: gap 2.5"), lines.get(0));
    assertTrue(lines.get(0).endsWith("overlap 0"), lines.get(0));
    assertTrue(lines.get(1).startsWith("middle to right: gap 1.5"), lines.get(1));
    assertEquals("middle: moved 0.50 mm, 10.0 degrees", lines.get(2));
    assertTrue(
        lines
            .get(0)
            .matches(
                "middle to left: gap -?\\d+\\.\\d\\d mm, at most -?\\d+\\.\\d\\d; [^;]+;"
                    + " contact on \\d+ of \\d+ mm\\^2; overlap 0"),
        "a fixed number of digits: " + lines.get(0));
  }

  @Test
  void theHeadingSaysWhetherTheFragmentIsInHand() {
    HeldReadings readings = new HeldReadings(bar, starts, Optional.empty());
    assertEquals("in hand: middle", readings.heading(1, true));
    assertEquals("touched last: left", readings.heading(0, false));
  }

  @Test
  void whatMovesWithItIsLeftOutAndOverlapIsCounted() {
    HeldReadings readings = new HeldReadings(bar, starts, Optional.empty());
    List<RigidTransform> poses = transforms(new Pose(), moved(-2.5, 0), new Pose());
    List<String> lines = readings.lines(1, poses, BodyGroups.none(3).bound(1, 2));
    assertEquals(2, lines.size(), lines.toString());
    assertTrue(lines.get(0).startsWith("middle to left: gap -0.5"), lines.get(0));
    assertTrue(lines.get(0).endsWith("overlap 100"), lines.get(0));
  }

  @Test
  void aFragmentIsReadAgainstEachGhost() {
    SegmentedVolume ghosts =
        new SegmentedVolume(GRID, List.of(new Segment("ghost", part(0, 56), 0)));
    HeldReadings readings = new HeldReadings(bar, starts, Optional.of(ghosts));
    List<RigidTransform> poses = transforms(new Pose(), moved(1, 0), moved(0, 0));
    List<String> lines = readings.lines(1, poses, BodyGroups.none(3));
    assertEquals(4, lines.size(), lines.toString());
    assertTrue(lines.get(2).startsWith("middle to ghost: distance 0.0"), lines.get(2));
    poses = transforms(new Pose(), moved(300, 0), new Pose());
    lines = readings.lines(1, poses, BodyGroups.none(3));
    assertTrue(
        lines.contains("middle to ghost: no surface that looks the same way within 4 mm"),
        lines.toString());
  }

  @Test
  void aFragmentThatStartedElsewhereIsAlsoReadFromWhereItRests() {
    List<Pose> displaced = List.of(moved(3, 0), moved(9, 0), moved(5, 0));
    HeldReadings readings = new HeldReadings(bar, displaced, Optional.empty());
    List<RigidTransform> poses = transforms(moved(3, 0), moved(10, 0), moved(5, 0));
    List<String> middle = readings.lines(1, poses, BodyGroups.none(3));
    assertEquals("middle: moved 1.00 mm, 0.0 degrees", middle.get(middle.size() - 2));
    assertEquals("middle: from where it rests 7.00 mm, 0.0 degrees", middle.get(middle.size() - 1));
    List<String> largest = readings.lines(0, poses, BodyGroups.none(3));
    assertEquals("left: moved 0.00 mm, 0.0 degrees", largest.get(largest.size() - 1));
  }

  @Test
  void anAnchorFollowsItsBodyAndAPointOnNoneStays() {
    Vec3 point = new Vec3(30, 6, 11);
    List<RigidTransform> before = transforms(new Pose(), moved(1, 0.3), new Pose());
    List<RigidTransform> after = transforms(new Pose(), moved(4, 0.3), new Pose());
    Vec3 on = BodyAnchor.at(point, 1, before).present(after);
    assertEquals(0, on.sub(new Vec3(33, 6, 11), new Vec3()).length(), 1e-12);
    assertTrue(BodyAnchor.at(point, -1, before).present(after).sameBits(point));
    assertTrue(BodyAnchor.at(point, 1, List.of()).present(List.of()).sameBits(point));
  }
}
