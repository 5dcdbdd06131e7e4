package org.palpate.host.placing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.KeyEvent;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.palpate.device.HapticDevice;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.HandOverBlocks;
import org.palpate.host.MouseTakeover;

/** Takes two blocks that lie over a floor in hand, in sessions without a window. */
class PlacingKeysTest extends HandOverBlocks {
  private static final Vec3 MIDDLE_OF_BLOCK = new Vec3(20, 32, 12);

  private void start(HapticDevice device) {
    start(
        device,
        made ->
            new PlacingKeys(made, List.of("floor", "block", "small"), hints::add)
                .addTo(keys.input()));
  }

  private void awaitTurned(RigidTransform before, Vec3 seen) throws InterruptedException {
    for (int tick = 0; tick < 1000 && distanceFromTurned(before, seen) > 0.01; tick++) {
      assertFalse(session.supervise(), "the session goes on");
      TimeUnit.MILLISECONDS.sleep(10);
      session.takeUpdates();
    }
    assertEquals(0, distanceFromTurned(before, seen), 0.01);
  }

  /** Returns the distance of the block from where a turn about the hand brings it, mm. */
  private double distanceFromTurned(RigidTransform before, Vec3 seen) {
    Vec3 rotation = model.camera().turn(seen, model.axes());
    Quaternion turn = new Quaternion().setRotationVector(rotation);
    double most = 0;
    for (Vec3 corner : List.of(MIDDLE_OF_BLOCK, new Vec3(24, 32, 12), new Vec3(20, 36, 16))) {
      Vec3 lever = before.transform(corner, new Vec3()).sub(devicePoint(), new Vec3());
      Vec3 expected = turn.rotate(lever, lever).add(devicePoint(), lever);
      most = Math.max(most, distance(pose(BLOCK).transform(corner, new Vec3()), expected));
    }
    return most;
  }

  @Test
  void thirtyPressesTurnTheHeldBlockByNinetyDegreesAboutTheHand() throws InterruptedException {
    start(new Hand(hand, false));
    take(BLOCK, OVER_BLOCK);
    RigidTransform before = pose(BLOCK);
    for (int n = 0; n < 30; n++) {
      keys.press(KeyEvent.VK_RIGHT);
    }
    awaitTurned(before, new Vec3(0, Math.PI / 2, 0));
    RigidTransform turned = pose(BLOCK);
    for (int n = 0; n < 30; n++) {
      keys.press(KeyEvent.VK_LEFT);
    }
    awaitTurned(turned, new Vec3(0, -Math.PI / 2, 0));
    for (int n = 0; n < 5; n++) {
      keys.press(KeyEvent.VK_PAGE_UP);
      keys.wheel(0, 1);
      keys.wheel(1, 0);
    }
    awaitTurned(before, new Vec3(0, 0, Math.PI / 4));
    RigidTransform inPlane = pose(BLOCK);
    keys.drag(0.25);
    awaitTurned(inPlane, new Vec3(0, Math.PI / 4, 0));
    assertEquals(List.of(), hints);
  }

  @Test
  void whatIsPutDownStaysAndKeysTurnNothing() throws InterruptedException {
    start(new Hand(hand, false));
    take(BLOCK, OVER_BLOCK);
    keys.press(KeyEvent.VK_UP);
    letGo();
    RigidTransform put = pose(BLOCK);
    keys.press(KeyEvent.VK_UP);
    assertEquals(List.of("take hold of a body first"), hints);
    long frames = session.status().frames();
    await(() -> session.status().frames() > frames + 100);
    assertTrue(put.sameBits(pose(BLOCK)));
  }

  @Test
  void keysTurnWithTheMouseToo() throws InterruptedException {
    start(hand);
    take(BLOCK, OVER_BLOCK);
    RigidTransform before = pose(BLOCK);
    for (int n = 0; n < 10; n++) {
      keys.press(KeyEvent.VK_DOWN);
    }
    awaitTurned(before, new Vec3(Math.PI / 6, 0, 0));
  }

  @Test
  void aSimulatedHandTurnsWhatItHoldsItselfUntilTheMouseTakesOver() throws InterruptedException {
    MouseTakeover takeover =
        new MouseTakeover(new Hand(hand, false), contact.handTarget(), 1_000_000);
    start(takeover);
    take(BLOCK, OVER_BLOCK);
    RigidTransform before = pose(BLOCK);
    keys.press(KeyEvent.VK_RIGHT);
    keys.wheel(0, 1);
    String hint = "the simulated hand turns it: press with the mouse to take over";
    assertEquals(List.of(hint), hints.stream().distinct().toList());
    long frames = session.status().frames();
    await(() -> session.status().frames() > frames + 100);
    assertEquals(0, distanceFromTurned(before, new Vec3()), 0.01);
  }

  @Test
  void aDeviceWithOrientationKeepsItsOwn() throws InterruptedException {
    start(new Hand(hand, true));
    assertFalse(session.canTurnHeld());
    take(BLOCK, OVER_BLOCK);
    assertFalse(session.turnHeld(new Vec3(1, 0, 0)));
    keys.press(KeyEvent.VK_RIGHT);
    assertEquals(List.of(), hints, "the key has no action");
    keys.type('h');
    List<String> help = model.state().help();
    assertTrue(help.contains("the body in hand turns with the device"), help.toString());
  }

  @Test
  void locksAndBindsTheBodyInHand() throws InterruptedException {
    start(new Hand(hand, false));
    keys.type('2');
    take(BLOCK, OVER_BLOCK);
    keys.type('1');
    letGo();
    take(SMALL, OVER_SMALL);
    keys.type('1');
    assertTrue(frame().groups().moveTogether(BLOCK, SMALL));
    keys.type('2');
    assertTrue(frame().groups().isLocked(BLOCK));
    await(() -> frame().heldBody() < 0);
    assertEquals(
        List.of(
            "touch a body that can move first",
            "block is marked: touch another body and press 1, or 1 again to detach",
            "block and 1 more and small and 1 more move as one",
            "small and 1 more is locked"),
        hints);
  }
}
