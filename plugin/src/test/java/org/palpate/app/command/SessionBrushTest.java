package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.app.options.BrushOptions;
import org.palpate.collision.CollisionScene;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.BrushLimits;
import org.palpate.edit.EditListener;
import org.palpate.edit.EditQueue;
import org.palpate.edit.VoxelEdit;
import org.palpate.edit.VoxelWriter;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.loop.LoopSettings;
import org.palpate.volume.phantom.Phantom;

/** Paints in a session whose haptic thread does not run. */
class SessionBrushTest {
  private static final BrushOptions.Brush BALL =
      new BrushOptions.Brush(
          OptionalDouble.of(2), 0, BrushLimits.NONE, Optional.of(BrushOptions.Paint.ADD));

  private final ContactScene scene =
      new ContactScene(Phantom.parse("sphere:16").segments(), ContactSettings.standard());

  @Test
  void atMostOneEditOfABrushWaits() {
    LoopSettings loop = LoopSettings.ofRate(1000);
    SimulatedDevice device = new SimulatedDevice(1, scene.handTarget(), loop.periodNanos());
    try (TouchSession session = new TouchSession(scene, device, SessionSettings.standard())) {
      SessionBrush brush = new SessionBrush(BALL, session, scene.volume(), Optional.empty());
      for (int n = 0; n < 5; n++) {
        brush.tick();
      }
      applyAll();
      assertEquals(1, scene.edits().completed());
      brush.tick();
      brush.tick();
      int others = 0;
      while (session.offer(new VoxelEdit(0, 0, 0, 0, true))) {
        others++;
      }
      assertEquals(EditQueue.DEFAULT_CAPACITY - 1, others);
    }
  }

  private void applyAll() {
    CollisionScene solids = new CollisionScene(List.of(scene.volume().segments().get(0).bits()));
    scene.edits().applyTo(new VoxelWriter(solids, EditListener.NONE), 1 << 20);
    assertTrue(scene.edits().isIdle());
  }
}
