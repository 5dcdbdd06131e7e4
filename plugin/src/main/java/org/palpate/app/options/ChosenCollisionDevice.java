package org.palpate.app.options;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.palpate.collision.CollisionDevice;

/** The collision device of a session or a replay. Reports once if it fails. */
public final class ChosenCollisionDevice implements AutoCloseable {
  private final CollisionDevice device;
  private final PrintWriter err;
  private boolean isReported;

  ChosenCollisionDevice(CollisionDevice device, PrintWriter err) {
    this.device = device;
    this.err = err;
  }

  /** Returns the device. */
  public CollisionDevice device() {
    return device;
  }

  /** Prints a line if the device has failed since the last call. */
  public void reportFailure() {
    Optional<String> failure = device.failure();
    if (failure.isPresent() && !isReported) {
      isReported = true;
      err.println(
          "palpate: collision device "
              + device.name()
              + ": "
              + failure.get()
              + ": the CPU has taken over, with the same results");
      err.flush();
    }
  }

  /** Returns the fields of a report. */
  public Map<String, Object> fields() {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("name", device.name());
    fields.put("batches", device.batches());
    fields.put("failure", device.failure().orElse(""));
    return fields;
  }

  @Override
  public void close() {
    reportFailure();
    device.close();
  }
}
