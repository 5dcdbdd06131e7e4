package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.VoxelGrid;

class GridDeviceTest {
  /** Grid axis x runs along world y, y along -x and z along z. */
  private static final RigidTransform TURNED =
      new RigidTransform(
          new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(10, 20, 30));

  private static final VoxelGrid GRID = new VoxelGrid(8, 8, 8, new Vec3(0.5, 2, 4), TURNED);

  private final ScriptedDevice world = ScriptedDevice.at(6, 21, 38);

  @Test
  void aDeviceInTheWorldIsReadInGridCoordinates() {
    DeviceState state = new DeviceState();
    assertEquals(ReadStatus.FRESH, GridDevice.fromWorld(world, GRID).device().read(state));
    assertEquals("(2.0, 2.0, 2.0)", state.positionMm.toString());
  }

  @Test
  void aForceAlongAnAxisOfTheGridTurnsIntoTheWorld() {
    HapticDevice onGrid = GridDevice.fromWorld(world, GRID).device();
    assertTrue(onGrid.write(new Vec3(3, 0, 0), new Vec3()));
    assertEquals("(0.0, 3.0, 0.0)", world.forces.get(0).toString());
    world.reachable = false;
    assertFalse(onGrid.write(new Vec3(3, 0, 0), new Vec3()), "the device could not be reached");
  }

  @Test
  void aDeviceInGridCoordinatesStaysAsItIs() {
    assertSame(world, GridDevice.inGridCoordinates(world).device());
  }

  /** A device of one kind of coordinates does not compile where the other is asked for. */
  @Test
  void aGridDeviceIsNoDeviceInTheWorld() {
    assertFalse(HapticDevice.class.isAssignableFrom(GridDevice.class));
    assertFalse(GridDevice.class.isAssignableFrom(HapticDevice.class));
  }
}
