package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushEdit;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.geometry.Vec3;
import org.palpate.loop.LoopEnd;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Live sessions with elastic segments; they run in real time, for some seconds. */
@Timeout(120)
class ElasticSessionTest {
  private static final int EDGE = 32;
  private final ContactScene scene = new ContactScene(volume(), settings());
  private final LastForce device =
      new LastForce(new SimulatedDevice(7, scene.handTarget(), 1_000_000));

  /** A cube that the thread of the updates cannot read, as if it had run out of memory. */
  private static final class UnreadableForUpdates extends BitCube {
    UnreadableForUpdates() {
      super(EDGE, EDGE, EDGE);
    }

    @Override
    public boolean get(int i, int j, int k) {
      if (Thread.currentThread().getName().equals("palpate-elastic")) {
        throw new IllegalStateException("no memory");
      }
      return super.get(i, j, k);
    }
  }

  private static final class LastForce extends DeviceDecorator {
    private volatile double lastNewton;
    private volatile double mostNewton;

    LastForce(HapticDevice device) {
      super(device);
    }

    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      lastNewton = forceNewton.length();
      mostNewton = Math.max(mostNewton, lastNewton);
      return super.write(forceNewton, torqueNewtonMm);
    }
  }

  private static SegmentedVolume volume() {
    BitCube bits = new UnreadableForUpdates();
    for (int k = 0; k < 12; k++) {
      for (int j = 4; j < 28; j++) {
        for (int i = 4; i < 28; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return new SegmentedVolume(
        VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), List.of(new Segment("pad", bits, 0xFFFFFF)));
  }

  private static ContactSettings settings() {
    return ContactSettings.builder(SolverKind.SMOOTH).stiffness(0.5).build();
  }

  private ElasticBody body() {
    BitCube bits = scene.volume().segments().get(0).bits();
    ElasticSegment pad = new ElasticSegment(bits, new ElasticMaterial(20e3, 0.4));
    return new ElasticBody(
        new ControlLattice(scene.metric(), List.of(pad), List.of(), 8), scene.metric());
  }

  private TouchSession session() {
    return new TouchSession(
        scene, device, SessionSettings.standard().withElastic(Optional.of(this::body)));
  }

  /** Supervises until the session ends or some frames are over; returns whether it ended. */
  private static boolean supervise(TouchSession session, long frames) {
    boolean ended = false;
    while (!ended && session.status().frames() < frames) {
      ended = session.supervise();
      LockSupport.parkNanos(TouchSession.SUPERVISION_PERIOD_NANOS);
    }
    return ended;
  }

  @Test
  void pressesWhileAnotherThreadUpdates() {
    try (TouchSession session = session()) {
      session.start();
      assertFalse(supervise(session, 4000));
      assertEquals(LoopEnd.Cause.STOPPED, session.stop().cause());
      assertTrue(session.elastic().orElseThrow().counters().updates() > 10);
      assertEquals(Optional.empty(), session.elasticTrouble());
      assertTrue(device.mostNewton > 0.1, "largest force " + device.mostNewton);
    }
    assertEquals(0, device.lastNewton);
  }

  @Test
  void keepsTheLastShapeIfUpdatesFailAndEndsWithZeroForce() {
    try (TouchSession session = session()) {
      session.start();
      supervise(session, 500);
      scene.edits().offer(new BrushEdit(0, new Vec3(16, 16, 6), 2, false));
      assertTrue(supervise(session, Long.MAX_VALUE), "ended");
      assertTrue(session.endedByTrouble());
      assertTrue(session.elasticTrouble().orElseThrow().contains("no memory"));
      assertEquals("no memory", session.elasticFailure().orElseThrow().getMessage());
      assertEquals(LoopEnd.Cause.STOPPED, session.stop().cause());
      assertTrue(device.mostNewton > 0.1, "largest force " + device.mostNewton);
    }
    assertEquals(0, device.lastNewton);
  }
}
