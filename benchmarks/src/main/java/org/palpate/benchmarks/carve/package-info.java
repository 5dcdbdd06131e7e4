/**
 * Measures tools that cut: times, and attacks on the guarantee and on undo.
 *
 * <p>Uses {@code benchmarks.rigid} and {@code carve}. One thread. Millimetres and newtons.
 */
package org.palpate.benchmarks.carve;
