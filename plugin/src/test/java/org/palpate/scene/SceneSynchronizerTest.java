package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.VoxelGrid;

class SceneSynchronizerTest {
  private static final long PATIENCE_S = 60;

  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final VoxelGrid grid =
      new VoxelGrid(
          10,
          10,
          10,
          new Vec3(1, 1, 2),
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(1, 0, 0), new Vec3(0, 0, 1), new Vec3(5, 6, 7)));
  private final SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
  private final SceneSynchronizer sync = new SceneSynchronizer(properties, grid, model, List::of);
  private final AtomicInteger redraws = new AtomicInteger();

  @Test
  void aThousandFramesBetweenTwoTicksCauseOneRedrawOfTheLast() {
    model.onChange(redraws::incrementAndGet);
    for (int frame = 1; frame <= 1000; frame++) {
      publish(frame / 1000.0, frame);
    }
    sync.run();
    assertEquals(1, redraws.get());
    Vec3 device = model.state().marks().orElseThrow().device();
    assertEquals(-5 - 0, device.x, 1e-12, "RAS x goes to the right, the scene's to the left");
    assertEquals(-(6 + 1.0), device.y, 1e-12, "grid x is the world's y");
    assertEquals(7, device.z, 1e-12);
  }

  @Test
  void aDeviceAtRestCausesNoRedraw() {
    model.onChange(redraws::incrementAndGet);
    publish(1, 1);
    sync.run();
    for (int frame = 2; frame < 100; frame++) {
      publish(1, frame);
      sync.run();
    }
    assertEquals(1, redraws.get());
    assertEquals(1, sync.applications());
  }

  @Test
  void changesThatAFailingRendererMissedAreAppliedAtTheNextTick() {
    AtomicInteger calls = new AtomicInteger();
    model.onChange(
        () -> {
          if (calls.incrementAndGet() == 1) {
            throw new IllegalStateException("renderer");
          }
        });
    publish(3, 1);
    assertThrows(IllegalStateException.class, sync::run);
    sync.run();
    assertEquals(2, calls.get());
    assertEquals(-(6 + 3.0), model.state().marks().orElseThrow().device().y, 1e-12);
  }

  @Test
  void theThreadContinuesAfterFailingTicksAndReportsTheFirst() throws Exception {
    CountDownLatch ticks = new CountDownLatch(5);
    List<String> told = new CopyOnWriteArrayList<>();
    Runnable failing =
        () -> {
          ticks.countDown();
          throw new IllegalStateException("tick");
        };
    try (SynchronizationThread thread =
        new SynchronizationThread(failing, failure -> told.add(failure.getMessage()))) {
      thread.start();
      assertTrue(ticks.await(PATIENCE_S, TimeUnit.SECONDS));
    }
    assertEquals(List.of("tick"), told);
  }

  private void publish(double x, long frame) {
    properties.publish(new Vec3(x, 0, 0), new Vec3(x, 0, 0), new Vec3(), false, frame);
  }
}
