/**
 * Measures the cost of publishing scene properties to the scene, beside the paper's method.
 *
 * <p>Uses {@code sync} and {@code benchmarks.report}. One writer and one reader thread. Nanoseconds
 * per frame.
 */
package org.palpate.benchmarks.sync;
