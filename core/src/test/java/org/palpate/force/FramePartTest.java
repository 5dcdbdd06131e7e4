package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;

/** Bounds of a frame at 1, 5 and 10 kHz, at which they last as long. */
class FramePartTest {
  @Test
  void aFrameHasItsPartOfAMillisecondAndNoMore() {
    assertEquals(1, FramePart.ofNanos(1_000_000));
    assertEquals(0.1, FramePart.ofNanos(100_000), 1e-15);
    assertEquals(1, FramePart.ofNanos(7_000_000), "a late frame is no reason for a jump");
    assertEquals(1, FramePart.ofNanos(0), "no time is known");
    assertEquals(0.2, FramePart.ofSeconds(0.0002), 1e-15);
  }

  @ParameterizedTest
  @ValueSource(longs = {1_000_000, 200_000, 100_000})
  void aJumpReachesAHandAtRestInTheSameTime(long periodNanos) {
    ForceRateLimit limit = new ForceRateLimit(1);
    limit.limit(new Vec3(), 0.5, 0);
    Vec3 force = new Vec3();
    long frames = 0;
    while (force.z < 1 - 1e-9) {
      limit.advance(periodNanos);
      limit.limit(force.set(0, 0, 1), 0.5, 0);
      frames++;
    }
    double perMs = ForceRateLimit.STIFFNESS_FACTOR * 0.5 * ChangeBound.MIN_MOTION_EDGES;
    assertEquals(1 / perMs, frames * periodNanos / 1e6, 1);
  }

  @ParameterizedTest
  @ValueSource(longs = {1_000_000, 200_000, 100_000})
  void aMaterialPassesToTheNextInTheSameTime(long periodNanos) {
    Material soft = new Material(0.1, 0, 0, 0);
    Material hard = new Material(0.5, 0, 0, 0);
    ForceSettings settings = new ForceSettings(soft, FrictionForm.CONE, true, List.of(soft, hard));
    MaterialTransition felt = new MaterialTransition(1, soft);
    felt.follow(settings, 0, true, 2, 0);
    long frames = 0;
    while (felt.stiffnessNewtonPerMm() < 0.5) {
      felt.advance(periodNanos);
      felt.follow(settings, 1, true, 2, 0);
      frames++;
    }
    // The bound of the change counts stiffness twice: 0.4 N/mm of 2 mm, at 0.025 N in a ms.
    assertEquals(2 * 0.4 * 2 / 0.025, frames * periodNanos / 1e6, 4);
  }
}
