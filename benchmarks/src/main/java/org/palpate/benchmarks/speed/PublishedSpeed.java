package org.palpate.benchmarks.speed;

import java.util.Map;
import java.util.OptionalDouble;

/**
 * The speeds of the paper, in Java on one core of a 3.2 GHz Xeon W5580, with a real device.
 *
 * <p>Source: Vlasov, Friese, Wolter 2013, Table 1.
 */
final class PublishedSpeed {
  /** The name of the published times in the legend of a plot. */
  static final String SERIES = "published (Xeon W5580, real device)";

  private static final double NANOS_AT_ONE_KHZ = 1e6;

  /** Frames with response, kHz, by the condition of ours that has the same size of data. */
  private static final Map<String, Double> RESPONSE_KHZ =
      Map.of(
          "CThead 256x256x113", 146.0,
          "CThead to 532x532x464", 141.0,
          "LIDC to 512x512x520", 134.0);

  private PublishedSpeed() {}

  /** Returns the published time of a frame of Table 1, ns; empty if there is none. */
  static OptionalDouble nanos(String group, String condition) {
    Double khz = group.equals("table1") ? RESPONSE_KHZ.get(condition) : null;
    return khz == null ? OptionalDouble.empty() : OptionalDouble.of(NANOS_AT_ONE_KHZ / khz);
  }
}
