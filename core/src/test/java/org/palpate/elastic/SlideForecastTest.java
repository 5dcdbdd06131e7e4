package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class SlideForecastTest {
  private final SlideForecast forecast =
      new SlideForecast(
          ElasticTouch.softCube(new BitCube(40, 40, 40), 4, new GridMetric(1, 1, 2), 8).layout());
  private final Vec3 point = new Vec3(3, 5, 7);
  private final Vec3 ahead = new Vec3();

  private void slide(int frames, double voxelsPerFrame) {
    for (int n = 0; n < frames; n++) {
      point.x += voxelsPerFrame;
      forecast.follow(point, true, ahead);
    }
  }

  /** After two periods of 33 ms a point at 0.06 voxels a millisecond is 3.96 voxels further on. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 0.5, 0.1})
  void aSteadySlideGoesOnForTwoPeriodsAtAnyPace(double frameMs) {
    forecast.paced(frameMs);
    slide((int) (500 / frameMs), 0.06 * frameMs);
    assertEquals(point.x + 66 * 0.06, ahead.x, 1e-9);
    assertEquals(point.y, ahead.y);
  }

  @Test
  void theForecastIsAtMostOneCellAhead() {
    slide(500, 2);
    assertEquals(point.x + 8, ahead.x, 1e-9);
    point.z += 30; // A cell has four voxels along z.
    forecast.follow(point, true, ahead);
    assertTrue(ahead.z - point.z < 4, "ahead by " + (ahead.z - point.z));
  }

  @Test
  void aPointThatRestsIsItsOwnForecast() {
    slide(500, 0.1);
    slide(1_000, 0);
    assertTrue(ahead.sub(point, new Vec3()).length() < 1e-12);
  }

  @Test
  void nothingIsForecastWithoutContact() {
    slide(500, 0.1);
    forecast.follow(point, false, ahead);
    assertTrue(ahead.sameBits(point), "not pressed");
    point.x += 20;
    forecast.follow(point, true, ahead);
    assertTrue(ahead.sameBits(point), "the way to the contact is no slide");
    slide(500, 0.1);
    forecast.restart();
    point.x += 20;
    forecast.follow(point, true, ahead);
    assertTrue(ahead.sameBits(point), "placed anew");
  }
}
