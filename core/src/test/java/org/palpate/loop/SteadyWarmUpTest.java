package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SteadyWarmUpTest {
  private static final long LIMIT_NANOS = 1_000_000_000;

  private long now;
  private long frames;
  private long compiledMillis;
  private int leastFrames;

  @Test
  void endsWhenTheFrameIsCompiledAndItsTimeIsSteady() {
    SteadyWarmUp.Result result =
        run(
            () -> {
              boolean interpreted = frames < 3_000;
              now += interpreted ? 20_000 : 1_000;
              compiledMillis += interpreted && frames % 100 == 0 ? 1 : 0;
            });
    assertTrue(result.steady());
    assertEquals(5_000, result.frames(), "3,000 interpreted and four steady batches of 500");
    assertEquals(1_000, result.medianNanos());
  }

  @Test
  void continuesWhileTheCompilerWorksAtASteadyTime() {
    SteadyWarmUp.Result result =
        run(
            () -> {
              now += 1_000;
              compiledMillis += frames < 10_000 && frames % 500 == 0 ? 1 : 0;
            });
    assertTrue(result.steady());
    assertTrue(result.frames() >= 11_500, "frames=" + result.frames());
  }

  @Test
  void reportsThatTheFrameNeverBecameSteady() {
    SteadyWarmUp.Result result = run(() -> now += frames / 500 % 2 == 0 ? 1_000 : 3_000);
    assertFalse(result.steady());
    assertTrue(result.nanos() >= LIMIT_NANOS, "nanos=" + result.nanos());
  }

  @Test
  void isNotMisledByOneSlowFrame() {
    SteadyWarmUp.Result result = run(() -> now += frames == 1_234 ? 5_000_000 : 1_000);
    assertTrue(result.steady());
    assertEquals(2_000, result.frames());
  }

  @Test
  void runsTheLeastNumberOfFramesAtASteadyTime() {
    leastFrames = 10_000;
    assertEquals(10_000, run(() -> now += 1_000).frames());
  }

  private SteadyWarmUp.Result run(Runnable frame) {
    Runnable counted =
        () -> {
          frame.run();
          frames++;
        };
    return new SteadyWarmUp(() -> now, () -> compiledMillis).run(counted, leastFrames, LIMIT_NANOS);
  }
}
