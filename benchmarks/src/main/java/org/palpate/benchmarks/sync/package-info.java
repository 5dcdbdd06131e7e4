/**
 * Measures what handing scene properties to the scene costs, beside the paper's method.
 *
 * <p>Uses {@code sync} and {@code benchmarks.report}. One writer and one reader thread. Nanoseconds
 * a frame.
 */
package org.palpate.benchmarks.sync;
