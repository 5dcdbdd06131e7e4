package org.palpate.opencl;

import java.util.List;
import java.util.Locale;

/** Finds the OpenCL devices of this machine. Any thread. The first call loads JOCL. */
public final class OpenClCatalog {
  private static final String NO_DEVICE = "OpenCL has no device";

  private OpenClCatalog() {}

  /**
   * A device.
   *
   * @param name as its driver states it
   * @param platform the driver, with its version
   * @param isGpu whether it is a graphics card
   * @param why the reason if it cannot be used, otherwise empty
   */
  public record Entry(String name, String platform, boolean isGpu, String why) {
    /** Whether it can be used. */
    public boolean usable() {
      return why.isEmpty();
    }
  }

  /**
   * The result of a search for devices.
   *
   * @param devices all devices, graphics cards first
   * @param why the reason if OpenCL or every device cannot be used, otherwise empty
   */
  public record Listing(List<Entry> devices, String why) {}

  /** There are devices, but none of those that were asked for can be used. */
  static final class WrongChoiceException extends RuntimeException {
    private static final long serialVersionUID = 1;

    WrongChoiceException(String message) {
      super(message);
    }
  }

  /** Lists the devices. If OpenCL is absent or broken, the list is empty and says why. */
  public static Listing list() {
    List<Entry> devices;
    try {
      devices = JoclDevices.all().stream().map(JoclDevices.Found::entry).toList();
    } catch (RuntimeException | LinkageError e) {
      return new Listing(List.of(), missing(e));
    }
    if (devices.isEmpty()) {
      return new Listing(devices, NO_DEVICE);
    }
    boolean none = devices.stream().noneMatch(Entry::usable);
    return new Listing(devices, none ? devices.get(0).why() : "");
  }

  private static String missing(Throwable cause) {
    return OpenClDevice.reason(cause) + "; install the driver of your graphics card";
  }

  /**
   * Opens a device.
   *
   * @param part a part of its name in any case; empty for the first that can be used
   * @throws WrongChoiceException if there are others, but none of these can be used
   */
  static ClDriver open(String part) {
    return new JoclDriver(choose(JoclDevices.all(), part));
  }

  /** Returns the first device that has the name and can be used. */
  static JoclDevices.Found choose(List<JoclDevices.Found> all, String part) {
    String wanted = part.toLowerCase(Locale.ROOT);
    List<JoclDevices.Found> fitting =
        all.stream()
            .filter(found -> found.entry().name().toLowerCase(Locale.ROOT).contains(wanted))
            .toList();
    if (all.isEmpty()) {
      throw new IllegalStateException(NO_DEVICE);
    }
    if (fitting.isEmpty()) {
      throw new WrongChoiceException("no OpenCL device has this name");
    }
    return fitting.stream()
        .filter(found -> found.entry().usable())
        .findFirst()
        .orElseThrow(() -> new WrongChoiceException(fitting.get(0).entry().why()));
  }
}
