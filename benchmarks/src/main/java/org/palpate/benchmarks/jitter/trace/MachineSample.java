package org.palpate.benchmarks.jitter.trace;

/**
 * The kernel's counters at one moment, summed over all processors.
 *
 * @param nanos the moment, on the clock of {@link System#nanoTime}
 * @param stolenNanos time that the hypervisor gave to other guests
 * @param busyNanos time in which some thread ran
 * @param idleNanos time in which no thread ran
 */
record MachineSample(long nanos, long stolenNanos, long busyNanos, long idleNanos) {}
