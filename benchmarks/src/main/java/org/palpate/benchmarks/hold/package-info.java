/**
 * Measures the frames of live sessions in which the hand holds a fragment among others.
 *
 * <p>Uses {@code benchmarks.jitter.experiment}, {@code benchmarks.rigid} and {@code host.placing}.
 * World millimetres.
 */
package org.palpate.benchmarks.hold;
