package org.palpate.device.jni;

import java.util.ArrayList;
import java.util.List;

/**
 * Lists the devices that can be used here, by back end, and opens them. A probe of a back end waits
 * up to 5 s for the vendor's library, and opening a device up to 10 s: not for the haptic thread.
 */
public final class DeviceCatalog {
  private static final int PROBE_WAIT_MILLIS = 5000;
  private static final int OPEN_WAIT_MILLIS = 10000;
  private static final List<String> NATIVE_BACKENDS =
      List.of("hid", "openhaptics", "forcedimension", "virtuose");

  private DeviceCatalog() {}

  /**
   * Returns the simulated hand and the replay, which can always be used, and then the result of
   * probing each native back end. The mouse is not listed, because it belongs to the window.
   */
  public static List<BackendProbe> probeAll() {
    List<BackendProbe> all = new ArrayList<>();
    all.add(builtIn("simulated", "a hand that approaches, presses, slides, taps and tears"));
    all.add(builtIn("replay", "a recorded trajectory: --device replay:FILE.csv"));
    for (String backend : NATIVE_BACKENDS) {
      all.add(probe(backend));
    }
    return all;
  }

  private static BackendProbe builtIn(String backend, String name) {
    return new BackendProbe(
        backend, true, "", "", "", List.of(new BackendProbe.Found("", name, true, "")));
  }

  /**
   * Probes one native back end.
   *
   * @throws IllegalArgumentException if there is no back end of this name
   */
  public static BackendProbe probe(String backend) {
    if (!NativeLibrary.isLoaded()) {
      return new BackendProbe(backend, false, "", "", NativeLibrary.loadFailure(), List.of());
    }
    String lines = NativeCalls.probe(backend, PROBE_WAIT_MILLIS);
    if (lines == null) {
      throw new IllegalArgumentException("no such back end: backend=" + backend);
    }
    return BackendProbe.parse(backend, lines);
  }

  /**
   * Captures what a device of the HID protocol sends. The device gets zero forces, and then none
   * for longer than its watchdog waits.
   *
   * @param backend the name of the back end; only {@code hid} can be captured
   * @param id the serial number; empty for the first device
   * @return the lines of a capture, for {@link org.palpate.device.protocol.HidCapture#parse}
   * @throws DeviceException if it cannot be captured; the message gives the reason and the remedy
   */
  public static List<String> capture(String backend, String id) throws DeviceException {
    if (!NativeLibrary.isLoaded()) {
      throw new DeviceException(NativeLibrary.loadFailure());
    }
    String[] why = {""};
    String text = NativeCalls.capture(backend, id, OPEN_WAIT_MILLIS, why);
    if (text == null) {
      throw cannotOpen(backend, id, why[0]);
    }
    return text.lines().toList();
  }

  private static DeviceException cannotOpen(String backend, String id, String why) {
    String device = id.isEmpty() ? backend : backend + ":" + id;
    return new DeviceException("cannot open the device: " + device + ": " + why);
  }

  /**
   * Whether a back end for hardware has this name. False for {@code empty}, which {@link #open}
   * accepts too.
   */
  public static boolean isNative(String backend) {
    return NATIVE_BACKENDS.contains(backend);
  }

  /**
   * Opens a device.
   *
   * @param backend one of {@code hid}, {@code openhaptics}, {@code forcedimension}, {@code
   *     virtuose}; {@code empty} for one without hardware
   * @param id the serial number, name or host, as in {@link BackendProbe.Found#id}; empty for the
   *     first device
   * @throws DeviceException if it cannot be opened; the message gives the reason and the remedy
   */
  public static NativeDevice open(String backend, String id) throws DeviceException {
    if (!NativeLibrary.isLoaded()) {
      throw new DeviceException(NativeLibrary.loadFailure());
    }
    String[] why = {""};
    long handle = NativeCalls.open(backend, id, OPEN_WAIT_MILLIS, why);
    if (handle == 0) {
      throw cannotOpen(backend, id, why[0]);
    }
    return new NativeDevice(handle);
  }
}
