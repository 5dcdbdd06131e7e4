package org.palpate.device.jni;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;

class NativeDeviceTest {

  @BeforeEach
  void needsTheNativeLibrary() {
    Assumptions.assumeTrue(NativeLibrary.isLoaded(), "skipped: " + NativeLibrary.loadFailure());
  }

  @Test
  void loadsTheLibraryFromTheJar() {
    assertTrue(NativeLibrary.origin().startsWith("jar:/natives/"), NativeLibrary.origin());
  }

  @Test
  void crossesBothWaysAndCountsItsReads() throws DeviceException {
    DeviceState state = new DeviceState();
    try (NativeDevice device = DeviceCatalog.open("empty", "")) {
      assertEquals("empty", device.specification().name());
      for (int i = 1; i <= 1000; i++) {
        assertEquals(ReadStatus.FRESH, device.read(state));
        assertEquals(i, state.timeNanos);
        assertEquals(1.0, state.orientation.w);
        assertTrue(device.write(new Vec3(i, 0, 0), new Vec3(0, i, 0)));
      }
    }
  }

  @Test
  void isGoneAfterCloseAndMayBeClosedTwice() throws DeviceException {
    NativeDevice device = DeviceCatalog.open("empty", "");
    device.close();
    device.close();
    assertEquals(ReadStatus.DISCONNECTED, device.read(new DeviceState()));
    assertFalse(device.write(new Vec3(), new Vec3()));
    assertEquals("", device.ending());
  }

  @Test
  void anOldHandleNeverReachesTheDeviceOpenedAfterIt() throws DeviceException {
    NativeDevice first = DeviceCatalog.open("empty", "");
    first.close();
    try (NativeDevice second = DeviceCatalog.open("empty", "")) {
      first.close();
      assertEquals(ReadStatus.DISCONNECTED, first.read(new DeviceState()));
      assertEquals(ReadStatus.FRESH, second.read(new DeviceState()));
    }
  }

  @Test
  void namesAnUnknownBackEndInOneLine() {
    DeviceException e =
        assertThrows(DeviceException.class, () -> DeviceCatalog.open("abacus", "7"));
    assertEquals("cannot open the device: abacus:7: no such back end", e.getMessage());
  }

  @Test
  void namesTheFileThatDoesNotLoadAndTheRemedyInOneLine() {
    String why =
        NativeLibrary.loadFile(Path.of("/no/such.so"), "given", "name the right one").loadFailure;
    assertTrue(why.startsWith("cannot load the native library: given: "), why);
    assertTrue(why.contains("/no/such.so") && why.endsWith(": name the right one"), why);
    assertEquals(1, why.lines().count(), why);
  }

  @Test
  void namesTheLibraryOfEveryPlatform() {
    assertEquals(
        "/natives/linux-x86_64/libpalpate.so", NativeLibrary.resourceName("Linux", "amd64"));
    assertEquals(
        "/natives/windows-x86_64/palpate.dll", NativeLibrary.resourceName("Windows 11", "amd64"));
    assertEquals(
        "/natives/macos-aarch64/libpalpate.dylib",
        NativeLibrary.resourceName("Mac OS X", "aarch64"));
  }
}
