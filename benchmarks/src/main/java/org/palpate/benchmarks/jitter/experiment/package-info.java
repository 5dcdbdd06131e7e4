/**
 * Defines an experiment (JDK, collector, wait, scheduling, workload, background load) and runs it
 * in a fresh process.
 *
 * <p>Uses {@code benchmarks.jitter.trace} for its files. The measured loop allocates nothing
 * between its first and last sample. Nanoseconds.
 */
package org.palpate.benchmarks.jitter.experiment;
