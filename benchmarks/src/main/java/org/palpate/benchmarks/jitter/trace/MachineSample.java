package org.palpate.benchmarks.jitter.trace;

/**
 * What the kernel had counted at a moment, over all processors.
 *
 * @param nanos on the clock of {@link System#nanoTime}
 * @param stolenNanos time that the hypervisor gave to others
 * @param busyNanos time that any thread ran
 * @param idleNanos time that none ran
 */
record MachineSample(long nanos, long stolenNanos, long busyNanos, long idleNanos) {}
