/**
 * Measures how well a simulated hand puts the fragments of broken bones back.
 *
 * <p>Uses {@code benchmarks.rigid} and {@code reduction}. One thread. World millimetres.
 */
package org.palpate.benchmarks.fracture;
