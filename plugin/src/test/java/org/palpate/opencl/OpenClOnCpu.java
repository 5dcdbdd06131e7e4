package org.palpate.opencl;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.List;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.PointSet;
import org.palpate.opencl.OpenClDevice.Choice;

/** Opens an OpenCL device for tests, as a rule PoCL, which needs no GPU. */
final class OpenClOnCpu {
  /** A deadline for tests that measure nothing, ns: the machine may be busy. */
  static final long PATIENT_NANOS = 120_000_000_000L;

  private OpenClOnCpu() {}

  /** Returns the first device that can be used; skips the test if there is none, and says why. */
  static JoclDevices.Found device() {
    OpenClCatalog.Listing listing = OpenClCatalog.list();
    assumeTrue(
        listing.why().isEmpty(),
        "skipped, because it needs OpenCL (apt-get install pocl-opencl-icd): " + listing.why());
    List<JoclDevices.Found> usable =
        JoclDevices.all().stream().filter(each -> each.entry().usable()).toList();
    return usable.get(0);
  }

  /** Returns a device that runs kernels from a source. */
  static OpenClDevice open(String source) {
    return device(new JoclDriver(device(), source), PATIENT_NANOS);
  }

  /** Returns a device that is used from the first leg on. */
  static OpenClDevice device(ClDriver driver, long deadlineNanos) {
    return new OpenClDevice(driver, deadlineNanos, OpenClOnCpu::always);
  }

  private static Choice always(OpenClLegs batch, PointSet points, long firstNanos) {
    return new Choice(0, MotionGroup.CAPACITY);
  }

  /** Returns the kernels with one piece of text replaced, which must be there. */
  static String sourceWith(String piece, String replacement) {
    String source = JoclDriver.source();
    if (!source.contains(piece)) {
      throw new AssertionError("the source of the kernels has no " + piece);
    }
    return source.replace(piece, replacement);
  }
}
