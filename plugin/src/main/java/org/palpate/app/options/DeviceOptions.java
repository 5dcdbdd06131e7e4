package org.palpate.app.options;

import java.util.List;
import org.palpate.app.process.PalpateException;
import org.palpate.device.DeviceSpecification;
import org.palpate.io.file.NumberText;
import org.palpate.loop.LoopSettings;
import picocli.CommandLine.Option;

/** The options of the device of a session and of its rate. */
public final class DeviceOptions {
  /** Below the smallest rate a frame would count as one that does not return. */
  private static final NumberRange RATE =
      new NumberRange("--rate", "the rate", 10, 100_000, "Hz", "1000");

  private static final double NANOS_PER_SECOND = 1e9;

  /** A rate that is hardly higher than that of the samples needs no note. */
  private static final double SLACK = 1.01;

  @Option(
      names = "--device",
      paramLabel = "NAME[:ID]",
      defaultValue = "simulated",
      description = {
        "The device: simulated[:SEED], replay:T.csv, hid[:SERIAL], openhaptics[:NAME],"
            + " forcedimension[:SERIAL], virtuose:HOST, or mouse (in the window).",
        "Default: ${DEFAULT-VALUE}."
      })
  private String device;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      defaultValue = "1000",
      description = "Frames per second, 10 to 100,000. Default: ${DEFAULT-VALUE}.")
  private double rateHz;

  /**
   * Checks the rate.
   *
   * @throws PalpateException exit code 2, if it is out of its range
   */
  public void check() {
    RATE.check(rateHz);
  }

  /** Returns the pace of the session's frames. */
  public LoopSettings loop() {
    return LoopSettings.ofRate(rateHz);
  }

  /**
   * Returns what the rate means for a device that delivers fewer samples; empty for another one.
   *
   * @param opened what the device states about itself
   */
  public List<String> notes(DeviceSpecification opened) {
    long intervalNanos = opened.reportIntervalNanos();
    double mostHz = intervalNanos > 0 ? NANOS_PER_SECOND / intervalNanos : rateHz;
    return rateHz <= SLACK * mostHz
        ? List.of()
        : List.of(
            "The device delivers "
                + NumberText.count(Math.rint(mostHz))
                + " samples a second; at "
                + NumberText.count(rateHz)
                + " Hz the frames between two samples hold the force.");
  }

  /** Whether the device is the mouse. */
  public boolean isMouse() {
    return device.equals("mouse");
  }

  /**
   * Returns the device.
   *
   * @throws PalpateException exit code 2, if its name is wrong
   */
  public DeviceChoice choice() {
    return DeviceChoice.parse(device);
  }
}
