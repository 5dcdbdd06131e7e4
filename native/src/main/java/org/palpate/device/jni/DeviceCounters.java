package org.palpate.device.jni;

/**
 * Counters of a device's samples since it was opened.
 *
 * @param samples samples received
 * @param merged samples replaced by a newer one before they were read
 * @param late samples that came after more than two report intervals
 * @param lost gaps in the device's sequence numbers
 * @param duplicated samples with the previous sequence number
 * @param outOfOrder samples older than the previous one; dropped
 * @param wrongLength samples of a wrong length; dropped
 * @param errors failed calls that the session survived
 */
public record DeviceCounters(
    long samples,
    long merged,
    long late,
    long lost,
    long duplicated,
    long outOfOrder,
    long wrongLength,
    long errors) {}
