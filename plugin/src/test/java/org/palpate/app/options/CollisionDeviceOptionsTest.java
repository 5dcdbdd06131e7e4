package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.volume.BitCube;

class CollisionDeviceOptionsTest {
  private final StringWriter notes = new StringWriter();
  private final PrintWriter err = new PrintWriter(notes);

  private static CollisionDeviceOptions options(String... arguments) {
    return Given.options(new CollisionDeviceOptions(), arguments);
  }

  /** A device that fails and is closed when the test says so. */
  private static final class FakeDevice implements CollisionDevice {
    private Optional<String> failure = Optional.empty();
    private int closed;

    @Override
    public DeviceVoxels keep(BitCube voxels) {
      throw new UnsupportedOperationException("no test asks for voxels");
    }

    @Override
    public String name() {
      return "fake";
    }

    @Override
    public Optional<String> failure() {
      return failure;
    }

    @Override
    public long batches() {
      return 41;
    }

    @Override
    public void close() {
      closed++;
    }
  }

  @Test
  void theDefaultIsTheCpuForEveryTool() {
    options().check(false);
    options().check(true);
    assertSame(CollisionDevice.CPU, options().open(err).device());
    options("--collision-device=cpu").explain(err, err);
    assertEquals("", notes.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"gpu", "opencl:", "openclX", "cpu:0", ""})
  void anUnknownDeviceIsRefused(String name) {
    Given.refuses(
        "there is no such collision device: --collision-device "
            + name
            + ": write cpu, opencl, or opencl:NAME with a name that palpate devices lists",
        () -> options("--collision-device=" + name).check(true));
  }

  @Test
  void aPointNeedsNoOtherDevice() {
    Given.refuses(
        "this option is for a rigid tool alone: --collision-device opencl: leave it out, or choose"
            + " a --tool",
        () -> options("--collision-device=opencl").check(false));
    options("--collision-device=opencl").check(true);
    options("--collision-device=opencl:Xe").check(true);
  }

  @Test
  void aDeviceThatNobodyHasIsRefusedOrReplacedByTheCpu() {
    CollisionDeviceOptions options = options("--collision-device=opencl:no such device");
    try (ChosenCollisionDevice chosen = options.open(err)) {
      assertSame(CollisionDevice.CPU, chosen.device(), "there is no OpenCL at all");
      assertTrue(
          notes.toString().startsWith("palpate: OpenCL cannot be used (")
              && notes.toString().contains(": --collision-device opencl:no such device: "),
          notes.toString());
    } catch (org.palpate.app.process.PalpateException e) {
      assertTrue(
          e.getMessage()
              .endsWith(
                  ": --collision-device opencl:no such device: choose one that palpate devices"
                      + " lists"),
          e.getMessage());
    }
  }

  @Test
  void aFailureIsPrintedOnceAndStandsInTheReport() {
    FakeDevice device = new FakeDevice();
    ChosenCollisionDevice chosen = new ChosenCollisionDevice(device, err);
    chosen.reportFailure();
    assertEquals("", notes.toString());
    assertEquals(Map.of("name", "fake", "batches", 41L, "failure", ""), chosen.fields());
    device.failure = Optional.of("it is gone");
    chosen.reportFailure();
    chosen.close();
    assertEquals(
        "palpate: collision device fake: it is gone: the CPU has taken over, with the same results"
            + System.lineSeparator(),
        notes.toString());
    assertEquals("it is gone", chosen.fields().get("failure"));
    assertEquals(1, device.closed);
  }

  @Test
  void aFailureThatNobodyAskedForIsPrintedAtTheEnd() {
    FakeDevice device = new FakeDevice();
    device.failure = Optional.of("it is gone");
    new ChosenCollisionDevice(device, err).close();
    assertTrue(notes.toString().contains("it is gone"), notes.toString());
  }
}
