package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.scene.MovableSlices.Mode;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class MovableSlicesTest {
  private static final Vec3 POINT = new Vec3(4.5, 6.99, -3);

  private final SceneModel model = new SceneModel(WorldAxes.LPS, Theme.DARK);
  private final AtomicInteger redraws = new AtomicInteger();
  private final GreySlices grey =
      new GreySlices(
          ScalarVolume.of(VoxelGrid.ofUnitVoxels(10, 20, 300), ScalarVolume.Storage.UINT8));

  private MovableSlices slices(Mode mode) {
    model.onChange(redraws::incrementAndGet);
    return new MovableSlices(model, new MovableSlices.Start(grey, mode, 1, 2, 3));
  }

  private String shown() {
    return model
        .state()
        .look()
        .slices()
        .map(planes -> planes.i() + " " + planes.j() + " " + planes.k())
        .orElse("none");
  }

  @Test
  void fixedSlicesIgnoreThePoint() {
    MovableSlices slices = slices(Mode.FIXED);
    assertEquals("1 2 3", shown());
    for (int tick = 0; tick < 9; tick++) {
      slices.follow(POINT);
    }
    assertEquals("1 2 3", shown());
    assertEquals(1, redraws.get());
  }

  @Test
  void slicesAtThePointPassThroughItsVoxelOrTheNearestOfTheGrid() {
    MovableSlices slices = slices(Mode.AT_POINT);
    assertEquals("none", shown());
    slices.follow(POINT);
    assertEquals("4 6 0", shown());
    assertTrue(slices.line().startsWith("slices at point 4, 6, 0"), slices.line());
  }

  @Test
  void aPointThatStaysInItsVoxelCausesNoRedraw() {
    MovableSlices slices = slices(Mode.AT_POINT);
    for (int tick = 0; tick < 30; tick++) {
      slices.follow(new Vec3(4 + tick / 40.0, 6.5, 7.5));
    }
    assertEquals(1, redraws.get());
  }

  @Test
  void aMovingPointMovesTheSlicesTenTimesASecond() {
    MovableSlices slices = slices(Mode.AT_POINT);
    for (int tick = 0; tick < 30; tick++) {
      slices.follow(new Vec3(4, 6, tick));
    }
    assertEquals(10, redraws.get());
  }

  @Test
  void movingSlicesThatFollowedThePointFixesThemOnePlaneFurther() {
    MovableSlices slices = slices(Mode.AT_POINT);
    slices.follow(POINT);
    slices.move(1);
    assertEquals("5 6 0", shown());
    slices.nextAxis();
    slices.nextAxis();
    slices.move(-1);
    assertEquals("5 6 0", shown(), "the grid ends here");
    slices.move(1);
    assertEquals("5 6 2", shown(), "across 300 voxels a step is two");
  }

  @Test
  void switchesSlicesOffAndOn() {
    MovableSlices slices = slices(Mode.OFF);
    assertEquals("", slices.line());
    slices.nextMode();
    assertEquals("1 2 3", shown());
    slices.nextMode();
    slices.follow(POINT);
    assertEquals("4 6 0", shown());
    slices.nextMode();
    assertEquals("none", shown());
    assertFalse(model.state().look().slices().isPresent());
  }
}
