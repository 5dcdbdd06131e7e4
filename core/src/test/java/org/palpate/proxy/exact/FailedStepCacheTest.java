package org.palpate.proxy.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** The proxy is at (8.5, 8.5, 8.5) and the device at (10.5, 11.5, 12.5) when a search fails. */
class FailedStepCacheTest {
  private static final double[] SPACING = {1, 2, 4};
  private static final GridMetric METRIC = new GridMetric(SPACING[0], SPACING[1], SPACING[2]);

  /** Less than the square of the distance of any end. */
  private static final double NEARER_THAN_ANY_END = 0;

  private final FailedStepCache cache = new FailedStepCache(METRIC, true);
  private final ProxyVoxel voxel = new ProxyVoxel(true);
  private final CollisionScene scene = new CollisionScene(List.of(new BitCube(16, 16, 16)));
  private final Vec3 p = new Vec3(8.5, 8.5, 8.5);
  private final Vec3 device = new Vec3(10.5, 11.5, 12.5);

  @Test
  void aSearchFailsAgainAsLongAsNothingChanges() {
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "before any search");
    searchInVain(new Vec3(9, 9, 9));
    assertTrue(failsAgain(NEARER_THAN_ANY_END));
    p.set(8.1, 8.9, 8.2);
    assertTrue(failsAgain(NEARER_THAN_ANY_END), "the proxy is still in its voxel");
  }

  @Test
  void nothingIsKnownAfterForgetOrSinceANewSearchOrIfNothingIsRemembered() {
    searchInVain(new Vec3(9, 9, 9));
    cache.forget();
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "forgotten");
    searchInVain(new Vec3(9, 9, 9));
    cache.begin(voxel, p, device, false);
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "a new search has begun");
    FailedStepCache remembersNothing = new FailedStepCache(METRIC, false);
    remembersNothing.begin(voxel, p, device, false);
    remembersNothing.remember();
    assertFalse(remembersNothing.wouldFailAgain(voxel, p, device, NEARER_THAN_ANY_END, false));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void theSearchIsRepeatedInAnotherVoxelOrForADeviceOnAnotherSide(int axis) {
    searchInVain(new Vec3(9, 9, 9));
    p.set(axis, 9.1);
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "another voxel");
    p.set(axis, 8.5);
    assertTrue(failsAgain(NEARER_THAN_ANY_END));
    device.set(axis, 8.4);
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "on the other side");
    device.set(axis, 8.5);
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "on neither side");
    device.set(axis, 9);
    assertTrue(failsAgain(NEARER_THAN_ANY_END), "on the same side");
  }

  @Test
  void theSearchIsRepeatedWhenTheDeviceBecomesFar() {
    searchInVain(new Vec3(9, 9, 9));
    assertFalse(cache.wouldFailAgain(voxel, p, device, NEARER_THAN_ANY_END, true));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void theSearchIsRepeatedWhenTheDeviceLeavesItsVoxelAlongAnAxisThatAnAttemptReached(int axis) {
    Vec3 end = new Vec3(9, 9, 9);
    end.set(axis, device.get(axis));
    searchInVain(end);
    double cell = Math.floor(device.get(axis));
    device.set(axis, cell);
    assertTrue(failsAgain(NEARER_THAN_ANY_END), "at the begin of its voxel");
    device.set(axis, Math.nextUp(cell + 1));
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "in the voxel behind");
    device.set(axis, Math.nextDown(cell));
    assertFalse(failsAgain(NEARER_THAN_ANY_END), "in the voxel before");
    device.set(axis, cell + 0.5);
    device.set((axis + 1) % 3, device.get((axis + 1) % 3) + 5);
    assertTrue(failsAgain(NEARER_THAN_ANY_END), "no attempt reached the other axis");
  }

  @Test
  void aBestEndReachesNoAxis() {
    cache.begin(locate(), p, device, false);
    cache.addBestEnd(new Vec3(device.x, 9, 9));
    cache.remember();
    device.x += 1;
    assertTrue(failsAgain(NEARER_THAN_ANY_END));
  }

  /** The ends stay, along the axis where a face stopped them, and follow the device elsewhere. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void theSearchIsRepeatedWhenAnEndIsNearerToTheDeviceThanTheProxyIs(int axis) {
    double spacing = SPACING[axis];
    Vec3 end = new Vec3().set(device);
    end.set(axis, device.get(axis) - 3);
    cache.begin(locate(), p, device, false);
    cache.addBestEnd(end);
    cache.remember();
    assertTrue(failsAgain(square(3 * spacing)));
    assertFalse(failsAgain(Math.nextUp(square(3 * spacing))));
    device.set(device.x + 0.25, device.y + 0.25, device.z + 0.25);
    assertTrue(failsAgain(square(3.25 * spacing)));
    assertFalse(failsAgain(Math.nextUp(square(3.25 * spacing))));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void anEndThatTheDeviceReachesOrPassesOnItsWayBackIsNoDistanceAway(int axis) {
    Vec3 end = new Vec3().set(device);
    end.set(axis, device.get(axis) - 0.5);
    cache.begin(locate(), p, device, false);
    cache.addBestEnd(end);
    cache.remember();
    device.set(axis, device.get(axis) - 1);
    assertFalse(failsAgain(Double.MIN_VALUE));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void anEndBehindTheDeviceStaysThereToo(int axis) {
    double spacing = SPACING[axis];
    Vec3 end = new Vec3().set(device);
    end.set(axis, device.get(axis) + 2);
    cache.begin(locate(), p, device, false);
    cache.addBestEnd(end);
    cache.remember();
    device.set(axis, device.get(axis) + 0.5);
    assertTrue(failsAgain(square(1.5 * spacing)));
    assertFalse(failsAgain(Math.nextUp(square(1.5 * spacing))));
    device.set(axis, device.get(axis) + 2.5);
    assertFalse(failsAgain(Double.MIN_VALUE), "the device has passed the end");
  }

  @Test
  void theDistanceOfAnEndCountsEveryAxis() {
    cache.begin(locate(), p, device, false);
    cache.addBestEnd(new Vec3(device.x - 1, device.y - 1, device.z - 1));
    cache.remember();
    assertEquals(21, square(1) + square(2) + square(4));
    assertTrue(failsAgain(21));
    assertFalse(failsAgain(21.001));
  }

  @Test
  void aSearchOfMoreAttemptsThanFitIsNotRemembered() {
    for (int ends = 24; ends <= 25; ends++) {
      cache.begin(locate(), p, device, false);
      for (int n = 0; n < ends; n++) {
        cache.addEnd(new Vec3(9, 9, 9));
      }
      cache.remember();
      assertEquals(ends == 24, failsAgain(NEARER_THAN_ANY_END), ends + " ends");
    }
  }

  private void searchInVain(Vec3 end) {
    cache.begin(locate(), p, device, false);
    cache.addEnd(end);
    cache.remember();
  }

  private boolean failsAgain(double square) {
    return cache.wouldFailAgain(locate(), p, device, square, false);
  }

  private ProxyVoxel locate() {
    voxel.locate(scene, p);
    return voxel;
  }

  private static double square(double length) {
    return length * length;
  }
}
