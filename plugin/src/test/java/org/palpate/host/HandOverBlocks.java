package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HapticDevice;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.HeadlessInput;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A hand over two blocks that lie over a floor, in a session without a window. */
public abstract class HandOverBlocks {
  protected static final int BLOCK = 1;
  protected static final int SMALL = 2;
  protected static final Vec3 OVER_BLOCK = new Vec3(20, 32, 30);
  protected static final Vec3 OVER_SMALL = new Vec3(44, 32, 30);

  protected final ContactScene contact =
      new ContactScene(volume(), placements(), ContactSettings.standard(), Optional.empty());
  protected final MouseDevice hand = new MouseDevice(contact.handTarget(), 1_000_000);
  protected final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  protected final HeadlessInput keys = new HeadlessInput(model);
  protected final List<String> hints = Collections.synchronizedList(new ArrayList<>());
  protected TouchSession session;

  /** A real device that a test moves; the session does not see that it is a mouse. */
  protected static final class Hand extends DeviceDecorator {
    private final boolean turns;

    public Hand(HapticDevice device, boolean turns) {
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

  /**
   * Starts a session.
   *
   * @param prepare gets the session before its start
   */
  protected final void start(HapticDevice device, Consumer<TouchSession> prepare) {
    session = new TouchSession(ToolScene.ofPoint(contact), device, SessionSettings.standard());
    prepare.accept(session);
    hand.moveTo(OVER_BLOCK);
    session.start();
    model.look(StandardView.FRONT, 1);
  }

  @AfterEach
  final void end() {
    session.close();
  }

  protected final ToolFrame frame() {
    return session.toolFrame().orElseThrow();
  }

  /** Waits until something is so, but for some 15 s at most. */
  protected final void await(BooleanSupplier isSo) throws InterruptedException {
    for (int tick = 0; tick < 1500 && !isSo.getAsBoolean(); tick++) {
      assertFalse(session.supervise(), "the session goes on");
      TimeUnit.MILLISECONDS.sleep(10);
      session.takeUpdates();
    }
    assertTrue(isSo.getAsBoolean());
  }

  protected final void awaitHandAt(Vec3 point) throws InterruptedException {
    hand.moveTo(point);
    await(() -> distance(devicePoint(), point) < 0.001);
  }

  protected final Vec3 devicePoint() {
    Vec3 device = session.properties().touch().device(new Vec3());
    return contact.grid().gridToWorld(device, device);
  }

  protected static double distance(Vec3 one, Vec3 other) {
    return one.sub(other, new Vec3()).length();
  }

  /** Presses a block from above, takes it and lifts it. */
  protected final void take(int body, Vec3 over) throws InterruptedException {
    awaitHandAt(over);
    hand.moveTo(new Vec3(over.x, over.y, 15));
    await(() -> frame().chosenBody() == body);
    session.toggleHold();
    await(() -> frame().heldBody() == body);
    awaitHandAt(new Vec3(over.x, over.y, 38));
  }

  protected final void letGo() throws InterruptedException {
    session.toggleHold();
    await(() -> frame().heldBody() < 0);
  }

  protected final RigidTransform pose(int body) {
    return session.bodyPoses().get(body);
  }
}
