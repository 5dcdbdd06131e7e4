package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** Presses the keys of undo and redo, and reads the lines that say why nothing happens. */
class UndoKeysTest extends HandOverBlocks {
  private SessionOverlay.UndoKeys undoKeys;

  @BeforeEach
  void startSession() {
    start(
        new Hand(hand, false),
        made -> {
          undoKeys = new SessionOverlay.UndoKeys(made, hints::add);
          undoKeys.addTo(keys.input());
        });
  }

  @Test
  void aRefusedUndoIsShownAndLaterItIsUndone() throws InterruptedException {
    awaitHandAt(OVER_BLOCK);
    RigidTransform start = pose(BLOCK);
    placeBlockAbove();
    moveSmallBy(-24); // under the block, where it was
    RigidTransform put = pose(BLOCK);
    keys.type('e');
    await(() -> hasHint("undo refused: a body has come there since"));
    assertTrue(put.sameBits(pose(BLOCK)));
    assertEquals(1, frame().voxels().history().refused());
    moveSmallBy(0);
    keys.type('e');
    await(() -> start.sameBits(pose(BLOCK)));
    undoKeys.tick();
    assertEquals(1, hints.size(), hints.toString());
    keys.type('y');
    await(() -> put.sameBits(pose(BLOCK)));
    assertEquals(1, hints.size(), hints.toString());
  }

  @Test
  void undoWaitsWhileABodyIsHeldAndSaysSo() throws InterruptedException {
    take(BLOCK, OVER_BLOCK);
    keys.type('e');
    assertEquals(List.of("undo waits until you let go"), hints);
    letGo();
    await(() -> frame().voxels().history().redoable() == 1);
    assertEquals(1, hints.size(), hints.toString());
  }

  private void placeBlockAbove() throws InterruptedException {
    take(BLOCK, OVER_BLOCK);
    letGo();
    awaitHandAt(new Vec3(20, 32, 60));
  }

  private void moveSmallBy(double x) throws InterruptedException {
    session.moveBody("small", Pose.at(x, 0, 0));
    await(() -> Math.abs(pose(SMALL).origin().x - x) < 1e-6);
  }

  private boolean hasHint(String hint) {
    undoKeys.tick();
    return hints.contains(hint);
  }
}
