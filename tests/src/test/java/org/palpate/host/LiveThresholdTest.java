package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.raycast.Ray;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.LegJudge;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A threshold that changes while the segment is touched. */
class LiveThresholdTest {
  private static final int EDGE = 32;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);

  private final ScalarVolume values = ScalarVolume.of(GRID, ScalarVolume.Storage.INT16);
  private final AtomicReference<BitCube> replaced = new AtomicReference<>();
  private long nowNanos;

  @Test
  void aSolidThatGrowsOverThePointSetsItFreeAndALaterLegTouchesNothing() throws Exception {
    ContactScene scene = scene();
    PointFrame frame = pressed(scene);
    Vec3 before = new Vec3().set(frame.point().position);
    try (LiveThreshold live = live(scene)) {
      live.change(-3);
      BitCube grown = awaitReplaced(frame);
      assertTrue(grown.get((int) before.x, (int) before.y, (int) before.z), "it grew over it");
      assertEquals(1, frame.statistics().freed());
      assertFree(grown, frame.point().position);
      LegJudge judge = new LegJudge(grown, frame.point().position);
      runJudged(frame, judge, 300);
      assertTrue(frame.point().contact && frame.forceLengthNewton() > 0);
      assertEquals("ball from 970", live.line());
    }
  }

  @Test
  void aSolidThatShrinksLetsThePointFollowWithoutSettingItFree() throws Exception {
    ContactScene scene = scene();
    PointFrame frame = pressed(scene);
    double height = frame.point().position.z;
    try (LiveThreshold live = live(scene)) {
      live.change(2);
      BitCube shrunk = awaitReplaced(frame);
      runJudged(frame, new LegJudge(shrunk, frame.point().position), 300);
      assertEquals(0, frame.statistics().freed());
      assertTrue(frame.point().position.z < height - 1);
    }
  }

  /**
   * A ball whose values fall by 10 a voxel from its middle, solid from 1000, which is 10 voxels.
   */
  private ContactScene scene() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          double radius = Math.hypot(Math.hypot(i - 15.5, j - 15.5), k - 15.5);
          values.set(i, j, k, Math.rint(1100 - 10 * radius));
          if (values.value(i, j, k) >= 1000) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return new ContactScene(
        new SegmentedVolume(GRID, List.of(new Segment("ball", bits, 0xffffff))),
        ContactSettings.standard(SolverKind.SMOOTH),
        Optional.of(GreyIsosurface.ofThreshold(values, 1000)));
  }

  private PointFrame pressed(ContactScene scene) {
    ScriptedDevice device =
        new ScriptedDevice(
            (read, state) ->
                ScriptedDevice.fresh(state, read, 16.2, 16.1, Math.max(22, 31 - 0.05 * read)));
    PointFrame frame =
        scene.newFrame(
            GridDevice.inGridCoordinates(device),
            scene.liveFrame(device.specification(), 0.5),
            FramePublisher.NONE);
    for (int n = 0; n < 400; n++) {
      run(frame);
    }
    assertTrue(frame.point().contact);
    return frame;
  }

  private LiveThreshold live(ContactScene scene) {
    LiveThreshold live =
        new LiveThreshold(
            scene,
            new LiveThreshold.Start(0, values, 1000, Double.POSITIVE_INFINITY, 1000),
            (segment, bits, grey) -> replaced.set(bits));
    live.start();
    return live;
  }

  private BitCube awaitReplaced(PointFrame frame) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (replaced.get() == null && System.nanoTime() < end) {
      run(frame);
    }
    return replaced.get();
  }

  private void runJudged(PointFrame frame, LegJudge judge, int frames) {
    for (int n = 0; n < frames; n++) {
      run(frame);
      assertNull(judge.faultOf(frame.point()));
    }
  }

  private void run(PointFrame frame) {
    nowNanos += ManualClock.MS;
    frame.run(nowNanos);
  }

  private static void assertFree(BitCube bits, Vec3 at) {
    Ray place = new Ray().from(at.x, at.y, at.z).to(at.x, at.y, at.z);
    assertFalse(ExactOracle.touchesAny(bits, place));
  }
}
