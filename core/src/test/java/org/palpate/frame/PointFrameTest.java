package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.BrushLimits;
import org.palpate.edit.BrushPath;
import org.palpate.edit.EditQueue;
import org.palpate.edit.ShapeEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.GreyMaterials;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.force.Material;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;

class PointFrameTest {
  private static final long MS = ManualClock.MS;
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final Floor floor = Floor.make();
  private final Vec3 hand = new Vec3(16, 16, 12);
  private final ScriptedDevice device = new ScriptedDevice(this::read);
  private long nowNanos = 1;

  private ReadStatus read(int read, DeviceState state) {
    return fresh(state, read, hand.x, hand.y, hand.z);
  }

  private void run(PointFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      assertEquals(FrameOutcome.RUNNING, frame.run(nowNanos));
      nowNanos += MS;
    }
  }

  private void moveTo(PointFrame frame, double x, double y, double z) {
    run(frame, 1);
    hand.set(x, y, z);
    run(frame, 20);
  }

  @Test
  void contactIsThatOfTheLastFrameAndItsFramesAreCounted() {
    PointFrame frame = floor.frame(device);
    run(frame, 7);
    assertFalse(frame.inContact());
    hand.z = 5;
    run(frame, 30);
    assertTrue(frame.inContact());
    assertEquals(30, frame.statistics().contactFrames());
    hand.z = 12;
    run(frame, 2);
    assertFalse(frame.inContact());
    assertEquals(30, frame.statistics().contactFrames());
    assertEquals(0, frame.statistics().freed());
  }

  @Test
  void aFrameWithoutANewSampleHasNoLegs() {
    PointFrame frame = floor.frame(device);
    run(frame, 2);
    hand.x = 17;
    run(frame, 1);
    assertTrue(frame.point().legs.count() > 0);
    assertTrue(frame.work() > 0);
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(frame, 1);
    assertEquals(0, frame.point().legs.count());
  }

  /** The force is that of a slew limit, so that a limiter which remembers it would be felt. */
  @Test
  void aSolidThatComesWhileTheDeviceIsSilentDropsTheForceInThatFrame() {
    FrameSettings slow =
        new FrameSettings(ForceSettings.of(0.5, 0), INFINITE, 0.25, 100 * MS, 200 * MS, 64);
    PointFrame frame = floor.frame(device, slow);
    moveTo(frame, 16.5, 16.5, 5);
    assertTrue(device.lastForce().z > 1);
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(frame, 2);
    assertTrue(device.lastForce().z > 1, "the last force is held");
    assertTrue(floor.edits.offer(new VoxelEdit(0, 16, 16, Floor.TOP, true)));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    assertEquals(0, frame.forceNewton().length());
    device.script = this::read;
    run(frame, 2);
    assertTrue(device.lastForce().length() < 0.1, "it rises from zero: " + device.lastForce());
  }

  @Test
  void releaseSaysWhetherTheDeviceGotZeroForce() {
    PointFrame frame = floor.frame(device);
    moveTo(frame, 16, 16, 5);
    assertTrue(frame.mayExertForce());
    assertTrue(frame.release());
    assertEquals(0, device.lastForce().length());
    assertEquals(0, frame.forceNewton().length());
    device.reachable = false;
    assertFalse(frame.release());
  }

  @Test
  void skipsOfTheScenePresentSolverAndFrictionAreCounted() {
    PointFrame frame = floor.frame(device);
    moveTo(frame, 16, 16, 12);
    run(frame, 100);
    Map<String, Long> skipped = frame.statistics().skipped();
    assertTrue(skipped.get(SkipKind.REST.key()) > 0, "" + skipped);
    assertTrue(skipped.get(SkipKind.FRICTION.key()) > 0, "" + skipped);
    List<BitCube> cubes = new ArrayList<>(List.of(floor.bits));
    for (int n = 0; n < 11; n++) {
      BitCube corner = new BitCube(32, 32, 32);
      corner.set(31, 31 - n, 31);
      cubes.add(corner);
    }
    PointFrame other =
        frame(new CollisionScene(cubes), Floor.settings(), new EditQueue(Floor.GRID, cubes.size()));
    moveTo(other, 16, 16, 12);
    moveTo(other, 10, 16, 6);
    assertTrue(
        other.statistics().skipped().get(SkipKind.FAR_OBJECTS.key()) > 0,
        "" + other.statistics().skipped());
  }

  private PointFrame frame(CollisionScene scene, FrameSettings settings, EditQueue edits) {
    return new PointFrame(
        GridDevice.inGridCoordinates(device),
        new GuardedSolver(Floor.METRIC, 8),
        scene,
        Floor.METRIC,
        settings,
        edits,
        FramePublisher.NONE);
  }

  /** The left half of the floor is soft, the right half hard. */
  @Test
  void eachObjectHasItsMaterialAlthoughNobodyObserves() {
    BitCube left = new BitCube(32, 32, 32);
    BitCube right = new BitCube(32, 32, 32);
    for (int n = 0; n < 32 * 32 * Floor.TOP; n++) {
      BitCube half = n % 32 < 16 ? left : right;
      half.set(n % 32, n / 32 % 32, n / 1024);
    }
    FrictionForm form = FrictionForm.EQUATION_4;
    ForceSettings materials =
        new ForceSettings(
            Material.of(0.5, 0, form),
            form,
            true,
            List.of(Material.of(0.125, 0, form), Material.of(0.75, 0, form)));
    FrameSettings settings = new FrameSettings(materials, INFINITE, INFINITE, 0, 20 * MS, 64);
    PointFrame frame =
        frame(new CollisionScene(List.of(left, right)), settings, new EditQueue(Floor.GRID, 2));
    moveTo(frame, 8, 16, 12);
    moveTo(frame, 8, 16, 6);
    assertEquals(0.125 * 2, device.lastForce().z, 1e-5);
    moveTo(frame, 24, 16, 12);
    moveTo(frame, 24, 16, 6);
    assertEquals(0.75 * 2, device.lastForce().z, 1e-5);
  }

  @Test
  void greyValuesGiveTheStiffnessWithAMassAndWithout() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    GreyMaterials soft = new GreyMaterials(values, List.of(new GreyMaterials.Row(0, 0.25, 0, 0)));
    FrameSettings settings =
        new FrameSettings(ForceSettings.of(0.5, 0), INFINITE, INFINITE, 0, 20 * MS, 64);
    PointFrame plain = floor.frame(device, settings);
    assertTrue(plain.mass().isEmpty());
    plain.use(soft);
    moveTo(plain, 16, 16, 12);
    moveTo(plain, 16, 16, 6);
    assertEquals(0.25 * 0.5 * 2, device.lastForce().z, 1e-5);
    PointFrame massive = floor.frame(device, settings);
    MassiveContact mass =
        new MassiveContact(Floor.METRIC, settings.force(), new MassSettings(0.05, new Vec3()));
    massive.give(mass);
    assertSame(mass, massive.mass().orElseThrow());
    massive.use(soft);
    moveTo(massive, 16, 16, 12);
    hand.z = 6;
    run(massive, 2000);
    double softNewton = device.lastForce().z;
    PointFrame hard = floor.frame(device, settings);
    hard.give(
        new MassiveContact(Floor.METRIC, settings.force(), new MassSettings(0.05, new Vec3())));
    moveTo(hard, 16, 16, 12);
    hand.z = 6;
    run(hard, 2000);
    assertTrue(softNewton < 0.9 * device.lastForce().z, softNewton + " of " + device.lastForce());
  }

  /** The body with mass would otherwise fly on from where the device was. */
  @Test
  void aBodyWithMassIsAtTheDeviceAfterAJump() {
    PointFrame frame = floor.frame(device);
    frame.give(
        new MassiveContact(
            Floor.METRIC, Floor.settings().force(), new MassSettings(0.2, new Vec3())));
    moveTo(frame, 5, 5, 20);
    device.script =
        (read, state) -> {
          state.relocated = true;
          return fresh(state, read, 25, 26, 21);
        };
    run(frame, 1);
    assertTrue(frame.wasFreed());
    device.script = (read, state) -> fresh(state, read, 25, 26, 21);
    run(frame, 3);
    assertEquals(0, frame.point().position.sub(new Vec3(25, 26, 21), new Vec3()).length(), 1e-9);
  }

  @Test
  void aPointWithMassTakesARequestedStiffness() {
    FrameSettings settings =
        new FrameSettings(ForceSettings.of(0.25, 0), INFINITE, INFINITE, 0, 20 * MS, 64);
    PointFrame frame = floor.frame(device, settings);
    frame.give(
        new MassiveContact(Floor.METRIC, settings.force(), new MassSettings(0.05, new Vec3())));
    moveTo(frame, 16, 16, 12);
    hand.z = 6;
    run(frame, 2000);
    double before = device.lastForce().z;
    frame.requestForce(ForceSettings.of(1, 0));
    run(frame, 2000);
    assertTrue(device.lastForce().z > 1.3 * before, device.lastForce().z + " after " + before);
  }

  /** The edits would act at the origin, where the floor is. */
  @Test
  void editsAtAToolThatNoSampleHasPlacedChangeNothing() {
    PointFrame frame = floor.frame(device);
    device.script = (read, state) -> ReadStatus.REPEATED;
    long solid = floor.bits.solidCount();
    floor.edits.offer(BrushEdit.atTool(0, new BrushPath(), 3, false, BrushLimits.NONE));
    floor.edits.offer(BrushEdit.atTool(0, new BrushPath(), 3, true, BrushLimits.NONE));
    run(frame, 5);
    assertEquals(solid, floor.bits.solidCount());
  }

  @Test
  void aPointHasNoShapeThatAnEditCouldUse() {
    PointFrame frame = floor.frame(device);
    moveTo(frame, 16, 16, 5);
    long solid = floor.bits.solidCount();
    floor.edits.offer(new ShapeEdit(0, (x, y, z) -> true, 4, false, BrushLimits.NONE));
    run(frame, 5);
    assertEquals(solid, floor.bits.solidCount());
  }

  @Test
  void theVoxelsOfAFrameAreThoseOfItsScene() {
    PointFrame frame = floor.frame(device);
    run(frame, 1);
    assertTrue(frame.voxels().write(0, 3, 4, 20, true));
    assertTrue(floor.bits.get(3, 4, 20));
  }

  @Test
  void badTimesAreThoseThatGoBackAndThoseThatStop() {
    PointFrame frame = floor.frame(device);
    run(frame, 20);
    device.script = (read, state) -> fresh(state, 19, 16, 16, 12);
    run(frame, 5);
    device.script = (read, state) -> fresh(state, 3, 16, 16, 12);
    run(frame, 4);
    assertEquals(9, frame.statistics().faults().badTimes());
  }
}
