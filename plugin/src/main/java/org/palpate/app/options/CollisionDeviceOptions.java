package org.palpate.app.options;

import java.io.PrintWriter;
import java.util.List;
import org.palpate.app.process.PalpateException;
import org.palpate.collision.CollisionDevice;
import org.palpate.opencl.LaunchExplanation;
import org.palpate.opencl.OpenClDevice;
import org.palpate.opencl.OpenClException;
import picocli.CommandLine.Option;

/** The option that chooses where the legs of a rigid tool are judged. */
public final class CollisionDeviceOptions {
  private static final String CPU = "cpu";
  private static final String OPENCL = "opencl";

  @Option(
      names = "--collision-device",
      paramLabel = "cpu|opencl[:NAME]",
      description = {
        "Where the legs of a rigid tool are judged: cpu, or opencl with a part of the device's"
            + " name. OpenCL is used for motions in which it was measured to be faster. The"
            + " results are the same. Default: ${DEFAULT-VALUE}."
      },
      defaultValue = CPU)
  private String text;

  /**
   * Checks the option.
   *
   * @param rigid whether there is a rigid tool
   * @throws PalpateException exit code 2, if there is no such device, or if the tool is a point,
   *     which needs none
   */
  public void check(boolean rigid) {
    boolean isOpenCl = isOpenCl();
    if (!isOpenCl && !text.equals(CPU)) {
      throw PalpateException.wrongUse(
          "there is no such collision device",
          given(),
          "write cpu, opencl, or opencl:NAME with a name that palpate devices lists");
    }
    if (isOpenCl && !rigid) {
      throw PalpateException.wrongUse(
          "this option is for a rigid tool alone", given(), "leave it out, or choose a --tool");
    }
  }

  private String given() {
    return "--collision-device " + text;
  }

  private boolean isOpenCl() {
    return text.equals(OPENCL) || (text.startsWith(OPENCL + ":") && !name().isEmpty());
  }

  private String name() {
    return text.length() > OPENCL.length() ? text.substring(OPENCL.length() + 1) : "";
  }

  /**
   * Opens the device. If OpenCL or the device cannot be used, the CPU takes its place, and a line
   * says so.
   *
   * @param err receives notes, a line each
   * @throws PalpateException exit code 2, if a name was given, and no device with this name is
   *     listed as usable
   */
  public ChosenCollisionDevice open(PrintWriter err) {
    if (!isOpenCl()) {
      return new ChosenCollisionDevice(CollisionDevice.CPU, err);
    }
    try {
      return new ChosenCollisionDevice(OpenClDevice.open(name()), err);
    } catch (OpenClException e) {
      if (e.isWrongChoice() && !name().isEmpty()) {
        throw PalpateException.wrongUse(
            e.getMessage(), given(), "choose one that palpate devices lists", e);
      }
      err.println(
          "palpate: OpenCL cannot be used ("
              + e.getMessage()
              + "): "
              + given()
              + ": continuing with the CPU");
      err.flush();
      return new ChosenCollisionDevice(CollisionDevice.CPU, err);
    }
  }

  /** Prints from how many points the device would be used on this machine, if one was chosen. */
  public void explain(PrintWriter out, PrintWriter err) {
    try (ChosenCollisionDevice chosen = open(err)) {
      if (chosen.device() instanceof OpenClDevice device) {
        out.println("The collision device " + device.name());
        List<String> lines = LaunchExplanation.of(device);
        lines.forEach(line -> out.println("  " + line));
        out.flush();
      }
    }
  }
}
