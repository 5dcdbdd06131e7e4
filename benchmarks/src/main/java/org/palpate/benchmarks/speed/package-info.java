/**
 * Runs the JMH benchmarks and compares them with the paper's table, with a port to C++, and with
 * each skip switched off.
 *
 * <p>Uses {@code benchmarks} and {@code benchmarks.report}. One thread. Nanoseconds per frame.
 */
package org.palpate.benchmarks.speed;
