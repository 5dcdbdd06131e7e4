/**
 * Simulates hand, device and coupling as a closed loop, and searches for the stiffness at which
 * each device becomes unstable.
 *
 * <p>Uses {@code force}, {@code frame} and {@code benchmarks.report}. One thread. Newtons,
 * millimetres, seconds.
 */
package org.palpate.benchmarks.stability;
