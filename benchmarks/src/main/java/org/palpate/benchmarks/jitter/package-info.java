/**
 * The command {@code jitter}: runs the chosen experiments and reports how late frames were, and
 * why.
 *
 * <p>Uses {@code benchmarks.jitter.experiment} and {@code benchmarks.jitter.trace}. One thread.
 * Nanoseconds inside, microseconds in reports.
 */
package org.palpate.benchmarks.jitter;
