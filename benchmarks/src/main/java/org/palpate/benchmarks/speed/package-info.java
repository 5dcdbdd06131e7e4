/**
 * Runs the JMH benchmarks and compares with the paper's table, with a C++ port, and with what each
 * skip saves.
 *
 * <p>Uses {@code benchmarks} and {@code benchmarks.report}. One thread. Nanoseconds a frame.
 */
package org.palpate.benchmarks.speed;
