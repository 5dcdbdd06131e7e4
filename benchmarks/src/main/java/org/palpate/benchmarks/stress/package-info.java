/**
 * Attacks solvers and frames with hostile motion and edits, and judges every leg in exact
 * arithmetic.
 *
 * <p>Uses {@code frame}, {@code host}, {@code benchmarks.input} and {@code benchmarks.report}. One
 * thread per run. Grid coordinates.
 */
package org.palpate.benchmarks.stress;
