/**
 * Defines an experiment (JDK, collector, wait, scheduling, workload, background load) and runs it
 * in a fresh process.
 *
 * <p>Method. The loop waits for absolute deadlines of a fixed grid, so that a late frame does not
 * shift those after it. Each frame records its deadline, start and end, and the kernel's counters
 * of the thread. A delayed loop omits deadlines; because no late frame is recorded for them, plain
 * percentiles are too low (coordinated omission). The reports therefore show the lateness as
 * measured and corrected. The cause of a late frame is found from the JVM's flight recording and
 * the kernel's counters between its deadline and its end.
 *
 * <p>Uses {@code benchmarks.jitter.trace} for its files. The measured loop allocates nothing
 * between its first and last sample. Nanoseconds.
 */
package org.palpate.benchmarks.jitter.experiment;
