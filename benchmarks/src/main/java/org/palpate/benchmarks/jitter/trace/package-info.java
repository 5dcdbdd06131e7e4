/**
 * Holds what an experiment leaves (samples, flight recording, counters of the machine) on one
 * clock, and finds why frames were late.
 *
 * <p>Uses {@code io} alone. The measured thread writes the samples; the rest is read afterwards.
 * Nanoseconds of {@code System.nanoTime}.
 */
package org.palpate.benchmarks.jitter.trace;
