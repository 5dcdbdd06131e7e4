package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SteadyWarmUpTest {
  private static final long LIMIT_NANOS = 1_000_000_000;
  private static final long FRAME_NANOS = 100_000;

  private long now;
  private long frames;
  private long restedNanos;
  private long questions;
  private boolean compilerIsBusy;
  private boolean othersPrepare;
  private int leastFrames;

  @Test
  void endsWhenTheTimeIsSteadyAndTheCompilerWasIdleTwice() {
    SteadyWarmUp.Result result = run(() -> now += FRAME_NANOS);
    assertTrue(result.steady());
    assertTrue(questions >= 2, "questions=" + questions);
    assertEquals(2_000, result.frames(), "four steady batches of 500");
    assertEquals(FRAME_NANOS, result.medianNanos());
  }

  @Test
  void continuesUntilFourBatchesTakeTheSameTime() {
    SteadyWarmUp.Result result = run(() -> now += frames < 1_500 ? 2 * FRAME_NANOS : FRAME_NANOS);
    assertTrue(result.steady());
    assertEquals(3_500, result.frames(), "1,500 slow frames and four steady batches of 500");
  }

  @Test
  void continuesWhileTheCompilerIsBusyAlthoughTheTimeIsSteady() {
    compilerIsBusy = true;
    SteadyWarmUp.Result result =
        run(
            () -> {
              now += FRAME_NANOS;
              compilerIsBusy = frames < 5_000;
            });
    assertTrue(result.steady());
    assertEquals(6_000, result.frames(), "two batches after the compiler has finished");
  }

  @Test
  void asksAgainBecauseFramesMayGiveAnIdleCompilerNewWork() {
    SteadyWarmUp.Result result =
        run(
            () -> {
              now += FRAME_NANOS;
              compilerIsBusy = frames / 500 % 2 == 1; // at every second question
            });
    assertFalse(result.steady());
    assertTrue(result.nanos() >= LIMIT_NANOS, "nanos=" + result.nanos());
  }

  @Test
  void leavesTheProcessorToTheCompilerBetweenBatches() {
    SteadyWarmUp.Result result = run(() -> now += FRAME_NANOS);
    assertEquals((result.frames() / 500 - 1) * 1_000_000, restedNanos);
  }

  @Test
  void restsAsLongAsItWorksWhileOthersPrepareTheSession() {
    othersPrepare = true;
    SteadyWarmUp.Result result =
        run(
            () -> {
              now += FRAME_NANOS;
              othersPrepare = frames < 1_000;
            });
    long batchNanos = 500 * FRAME_NANOS;
    assertEquals(2_000, result.frames());
    assertEquals(2 * batchNanos + 1_000_000, restedNanos, "two long rests and a short one");
  }

  @Test
  void restsForAMillisecondAlthoughOthersPrepareAndABatchIsShort() {
    othersPrepare = true;
    SteadyWarmUp.Result result = run(() -> now += 1_000);
    assertEquals((result.frames() / 500 - 1) * 1_000_000, restedNanos);
  }

  @Test
  void asksTheCompilerSeldomIfFramesAreShort() {
    run(() -> now += 1_000);
    assertEquals(2, questions, "they stop the JVM for a moment");
    assertTrue(frames >= 30_000, "frames=" + frames);
  }

  @Test
  void reportsThatTheFrameNeverBecameSteady() {
    SteadyWarmUp.Result result = run(() -> now += frames / 500 % 2 == 0 ? 100_000 : 300_000);
    assertFalse(result.steady());
    assertTrue(result.nanos() >= LIMIT_NANOS, "nanos=" + result.nanos());
  }

  @Test
  void isNotMisledByOneSlowFrame() {
    SteadyWarmUp.Result result = run(() -> now += frames == 1_234 ? 5_000_000 : FRAME_NANOS);
    assertTrue(result.steady());
    assertEquals(2_000, result.frames());
  }

  @Test
  void runsTheLeastNumberOfFramesAtASteadyTime() {
    leastFrames = 9_000;
    assertEquals(9_000, run(() -> now += FRAME_NANOS).frames());
  }

  private SteadyWarmUp.Result run(Runnable frame) {
    Runnable counted =
        () -> {
          frame.run();
          frames++;
        };
    return new SteadyWarmUp(() -> now, this::askCompiler, () -> othersPrepare, this::rest)
        .run(counted, leastFrames, LIMIT_NANOS);
  }

  private boolean askCompiler() {
    questions++;
    return compilerIsBusy;
  }

  private void rest(long nanos) {
    restedNanos += nanos;
    now += nanos;
  }
}
