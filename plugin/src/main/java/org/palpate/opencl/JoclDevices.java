package org.palpate.opencl;

import com.jogamp.opencl.CLDevice;
import com.jogamp.opencl.CLException;
import com.jogamp.opencl.CLPlatform;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.palpate.opencl.OpenClCatalog.Entry;

/** Lists the devices of all OpenCL platforms, through JOCL. */
final class JoclDevices {
  private JoclDevices() {}

  /** A device and what is known of it. */
  record Found(CLDevice device, Entry entry) {}

  /**
   * Returns all devices, graphics cards first.
   *
   * @throws IllegalStateException if this machine has no OpenCL
   */
  static List<Found> all() {
    if (!CLPlatform.isAvailable()) {
      throw new IllegalStateException("the library libOpenCL is missing");
    }
    List<Found> found = new ArrayList<>();
    for (CLPlatform platform : platforms()) {
      for (CLDevice device : platform.listCLDevices()) {
        found.add(new Found(device, entry(platform, device)));
      }
    }
    found.sort(Comparator.comparing(each -> !each.entry().isGpu()));
    return found;
  }

  private static CLPlatform[] platforms() {
    try {
      return CLPlatform.listCLPlatforms();
    } catch (CLException.CLPlatformNotFoundKhrException e) {
      throw new IllegalStateException("no OpenCL driver is installed", e);
    }
  }

  private static Entry entry(CLPlatform platform, CLDevice device) {
    return new Entry(
        device.getName().strip(),
        (platform.getName() + " " + platform.getVersion()).strip(),
        device.getType() == CLDevice.Type.GPU,
        refusal(device));
  }

  private static String refusal(CLDevice device) {
    if (!device.isAvailable()) {
      return "the device is not available";
    }
    if (!device.isDoubleFPAvailable()) {
      return "the device has no double-precision numbers, so its verdicts would not be exact";
    }
    return device.isCompilerAvailable() ? "" : "the device's driver has no compiler";
  }
}
