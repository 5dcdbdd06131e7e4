package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.DeviceSpecification;

class DeviceOptionsTest {
  private static DeviceOptions options(String... arguments) {
    return Given.options(new DeviceOptions(), arguments);
  }

  private static DeviceSpecification reporting(long intervalNanos) {
    return new DeviceSpecification("device", "", 3, 1, 100, intervalNanos);
  }

  @Test
  void withoutOptionsASimulatedHandRunsAThousandFramesASecond() {
    DeviceOptions options = options();
    options.check();
    assertFalse(options.isMouse());
    assertEquals(1_000_000, options.loop().periodNanos());
    assertEquals(DeviceChoice.parse("simulated"), options.choice());
  }

  @Test
  void theMouseIsKnownByItsName() {
    assertTrue(options("--device=mouse").isMouse());
    assertFalse(options("--device=hid").isMouse());
    assertEquals(500_000, options("--rate=2000").loop().periodNanos());
  }

  @ParameterizedTest
  @ValueSource(strings = {"9.9", "100001", "0", "-1000", "NaN"})
  void aRateOutOfItsRangeIsRefused(String hertz) {
    Given.refuses(
        "the rate must be a number from 10 to 100,000 Hz: --rate " + hertz + ": try --rate 1000",
        () -> options("--rate=" + hertz).check());
  }

  @Test
  void aDeviceThatDeliversFewerSamplesThanFramesIsNoted() {
    assertEquals(
        List.of(
            "The device delivers 250 samples a second; at 1,000 Hz the frames between two samples"
                + " hold the force."),
        options().notes(reporting(4_000_000)));
    assertEquals(
        List.of(
            "The device delivers 1,000 samples a second; at 5,000 Hz the frames between two"
                + " samples hold the force."),
        options("--rate=5000").notes(reporting(1_000_000)));
  }

  @Test
  void aDeviceThatDeliversAboutAsManySamplesIsNotNoted() {
    assertEquals(List.of(), options().notes(reporting(1_000_000)));
    assertEquals(List.of(), options().notes(reporting(1_005_000)), "995 samples a second");
    assertEquals(List.of(), options().notes(reporting(500_000)));
    assertEquals(List.of(), options().notes(reporting(0)), "it states no interval");
    assertEquals(1, options().notes(reporting(1_020_000)).size(), "980 samples a second");
  }
}
