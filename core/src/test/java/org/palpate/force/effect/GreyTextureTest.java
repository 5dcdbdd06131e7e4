package org.palpate.force.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A texture along each axis of a turned grid, against differences of the values along that axis.
 */
class GreyTextureTest {
  private static final int SIZE = 20;
  private static final Vec3 SPACING = new Vec3(1, 0.8, 1.5);
  private static final double MM_PER_VALUE = 1e-4;

  /** The axes of the grid in the world: x along y, y against x, z along z. */
  private static final Vec3[] AXES = {new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1)};

  private static final VoxelGrid GRID =
      new VoxelGrid(
          SIZE,
          SIZE,
          SIZE,
          SPACING,
          new RigidTransform(AXES[0], AXES[1], AXES[2], new Vec3(4, -3, 2)));

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final double[] profile = random.doubles(SIZE, -900, 900).map(Math::rint).toArray();

  private ScalarVolume along(int axis, IntToDoubleFunction value) {
    ScalarVolume volume = ScalarVolume.of(GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < SIZE * SIZE * SIZE; n++) {
      int[] at = {n % SIZE, n / SIZE % SIZE, n / (SIZE * SIZE)};
      volume.set(at[0], at[1], at[2], value.applyAsDouble(at[axis]));
    }
    return volume;
  }

  private static HapticEffect made(ScalarVolume grey, RigidTransform frameToWorld) {
    return Effects.texture(grey, MM_PER_VALUE)
        .make(new EffectSite(frameToWorld, 1, 0, 3, List.of(new Vec3())));
  }

  /** Returns the force at grid coordinates under a pressing force in the world. */
  private static Vec3 force(HapticEffect texture, Vec3 grid, Vec3 pressing) {
    HandState hand = new HandState();
    GRID.gridToWorld(grid, hand.tool.translation);
    hand.contactNewton.set(pressing);
    hand.contact = true;
    Vec3 force = new Vec3();
    texture.add(hand, force, new Vec3());
    return force;
  }

  /** Returns the profile at a grid coordinate, linear between the middles of voxels. */
  private double value(double coordinate) {
    double middle = coordinate - 0.5;
    int low = (int) Math.floor(middle);
    return profile[low] + (middle - low) * (profile[low + 1] - profile[low]);
  }

  /** Returns the value less the mean of its six neighbours, four of which are equal to it. */
  private double detail(double coordinate) {
    double v = value(coordinate);
    return v - (value(coordinate + 1) + value(coordinate - 1) + 4 * v) / 6;
  }

  @Test
  void theForceIsThePressingForceTimesTheSlopeOfTheDetailAlongTheAxis() {
    for (int axis = 0; axis < 3; axis++) {
      HapticEffect texture = made(along(axis, n -> profile[n]), RigidTransform.identity());
      Vec3 pressing = AXES[(axis + 1) % 3].mul(2.5, new Vec3());
      for (int n = 0; n < 200; n++) {
        Vec3 at = new Vec3(9.3, 9.7, 10.2);
        at.set(axis, random.nextDouble(4, SIZE - 4));
        double slope =
            MM_PER_VALUE
                * (detail(at.get(axis) + 0.5) - detail(at.get(axis) - 0.5))
                / SPACING.get(axis);
        double expected = -2.5 * Math.max(-0.5, Math.min(0.5, slope));
        Vec3 found = force(texture, at, pressing);
        assertEquals(expected, found.dot(AXES[axis]), 1e-9, "axis " + axis + " at " + at);
        assertEquals(Math.abs(expected), found.length(), 1e-9, "and along no other");
      }
    }
  }

  @Test
  void aTextureAlongThePressingForceIsNotFelt() {
    for (int axis = 0; axis < 3; axis++) {
      HapticEffect texture = made(along(axis, n -> profile[n]), RigidTransform.identity());
      Vec3 found = force(texture, new Vec3(9.3, 9.7, 10.2), AXES[axis].mul(3, new Vec3()));
      assertEquals(0, found.length(), 1e-9);
    }
  }

  /** A frame whose axes are the grid's, as that of an interaction point. */
  @Test
  void inAFrameAlongTheGridTheForceIsAlongTheGridToo() {
    HapticEffect texture = made(along(0, n -> profile[n]), GRID.gridMmToWorld());
    HandState hand = new HandState();
    hand.tool.translation.set(8.2, 7, 9);
    hand.contactNewton.set(0, 2, 0);
    Vec3 force = new Vec3();
    texture.add(hand, force, new Vec3());
    double slope = MM_PER_VALUE * (detail(8.7) - detail(7.7));
    assertEquals(-2 * Math.max(-0.5, Math.min(0.5, slope)), force.x, 1e-9);
    assertEquals(0, Math.hypot(force.y, force.z), 1e-9);
  }

  @Test
  void aSteepTextureIsCutToHalfThePressingForce() {
    HapticEffect texture =
        made(along(0, n -> n % 2 == 0 ? 30_000 : -30_000), RigidTransform.identity());
    double most = 0;
    for (double x = 5; x < 15; x += 0.05) {
      Vec3 found = force(texture, new Vec3(x, 9, 9), new Vec3(0, 0, 4));
      assertTrue(found.length() <= 2 + 1e-9);
      most = Math.max(most, found.length());
    }
    assertEquals(2, most, 1e-9);
  }

  @Test
  void aForceIsAddedToThatOfOtherEffects() {
    HapticEffect texture = made(along(0, n -> profile[n]), RigidTransform.identity());
    HandState hand = new HandState();
    GRID.gridToWorld(new Vec3(8.3, 9, 9), hand.tool.translation);
    hand.contactNewton.set(0, 0, 1);
    Vec3 alone = new Vec3();
    texture.add(hand, alone, new Vec3());
    Vec3 added = new Vec3(5, 6, 7);
    texture.add(hand, added, new Vec3());
    assertEquals(0, added.sub(alone, added).sub(new Vec3(5, 6, 7), added).length(), 1e-12);
  }
}
