package org.palpate.host.placing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.collision.CollisionDevice;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HapticDevice;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MouseDevice;
import org.palpate.host.SessionSettings;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.HeadlessInput;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** Takes two blocks that lie over a floor in hand, in sessions without a window. */
class PlacingKeysTest {
  private static final int BLOCK = 1;
  private static final int SMALL = 2;
  private static final Vec3 OVER_BLOCK = new Vec3(20, 32, 30);
  private static final Vec3 OVER_SMALL = new Vec3(44, 32, 30);
  private static final Vec3 MIDDLE_OF_BLOCK = new Vec3(20, 32, 12);

  private final ContactScene contact =
      new ContactScene(volume(), placements(), ContactSettings.standard(), Optional.empty());
  private final MouseDevice hand = new MouseDevice(contact.handTarget(), 1_000_000);
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private final HeadlessInput keys = new HeadlessInput(model);
  private final List<String> hints = Collections.synchronizedList(new ArrayList<>());
  private TouchSession session;

  /** A real device that a test moves; the session does not see that it is a mouse. */
  private static final class Hand extends DeviceDecorator {
    private final boolean turns;

    Hand(HapticDevice device, boolean turns) {
      super(device);
      this.turns = turns;
    }

    @Override
    public DeviceSpecification specification() {
      DeviceSpecification own = super.specification();
      return new DeviceSpecification(
          own.name(),
          own.serial(),
          own.maxForceNewton(),
          own.maxStiffnessNewtonPerMm(),
          own.workspaceRadiusMm(),
          own.reportIntervalNanos(),
          turns,
          0);
    }
  }

  private static SegmentedVolume volume() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(64, 64, 64);
    return new SegmentedVolume(
        grid,
        List.of(
            box(grid, "floor", 0, 64, 0, 64, 0, 4),
            box(grid, "block", 16, 24, 28, 36, 8, 16),
            box(grid, "small", 42, 46, 30, 34, 8, 16)));
  }

  private static Segment box(
      VoxelGrid grid, String name, int x0, int x1, int y0, int y1, int z0, int z1) {
    BitCube bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int k = z0; k < z1; k++) {
      for (int j = y0; j < y1; j++) {
        for (int i = x0; i < x1; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return new Segment(name, bits, 0);
  }

  private static List<Placement> placements() {
    return List.of(
        new Placement(Mobility.FIXED, new Pose()),
        new Placement(Mobility.MOVABLE, new Pose()),
        new Placement(Mobility.MOVABLE, new Pose()));
  }

  private void start(HapticDevice device) {
    BodyScene bodies = contact.newBodies();
    ToolScene scene =
        new ToolScene(
            contact,
            bodies,
            ToolSampler.point(),
            MovableShapes.ofPoints(bodies),
            List.of(Clearance.POINTS),
            OptionalDouble.empty(),
            CollisionDevice.CPU);
    session = new TouchSession(scene, device, SessionSettings.standard());
    new PlacingKeys(session, List.of("floor", "block", "small"), hints::add).addTo(keys.input());
    hand.moveTo(OVER_BLOCK);
    session.start();
    model.look(StandardView.FRONT, 1);
  }

  @AfterEach
  void end() {
    session.close();
  }

  private ToolFrame frame() {
    return session.toolFrame().orElseThrow();
  }

  /** Waits until something is so, but for some 15 s at most. */
  private void await(BooleanSupplier isSo) throws InterruptedException {
    for (int tick = 0; tick < 1500 && !isSo.getAsBoolean(); tick++) {
      assertFalse(session.supervise(), "the session goes on");
      TimeUnit.MILLISECONDS.sleep(10);
      session.takeUpdates();
    }
    assertTrue(isSo.getAsBoolean());
  }

  private void awaitHandAt(Vec3 point) throws InterruptedException {
    hand.moveTo(point);
    await(() -> distance(devicePoint(), point) < 0.001);
  }

  private Vec3 devicePoint() {
    Vec3 device = session.properties().touch().device(new Vec3());
    return contact.grid().gridToWorld(device, device);
  }

  private static double distance(Vec3 one, Vec3 other) {
    return one.sub(other, new Vec3()).length();
  }

  /** Presses a block from above, takes it and lifts it. */
  private void take(int body, Vec3 over) throws InterruptedException {
    awaitHandAt(over);
    hand.moveTo(new Vec3(over.x, over.y, 15));
    await(() -> frame().chosenBody() == body);
    session.toggleHold();
    await(() -> frame().heldBody() == body);
    awaitHandAt(new Vec3(over.x, over.y, 38));
  }

  private void letGo() throws InterruptedException {
    session.toggleHold();
    await(() -> frame().heldBody() < 0);
  }

  private RigidTransform pose(int body) {
    return session.bodyPoses().get(body);
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
