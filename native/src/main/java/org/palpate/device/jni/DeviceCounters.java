package org.palpate.device.jni;

/**
 * What befell the samples of a device since it was opened.
 *
 * @param samples taken
 * @param merged superseded by a newer one before they were read
 * @param late came after more than two report intervals
 * @param lost gaps in the device's sequence
 * @param duplicated the same sequence number again
 * @param outOfOrder older than the one before, dropped
 * @param wrongLength dropped for their length
 * @param errors calls that failed and that the session survived
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
