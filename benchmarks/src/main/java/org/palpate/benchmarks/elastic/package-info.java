/**
 * Measures elastic segments: an attack on the guarantee, times, steps of the force, work, rest, and
 * comparisons with formulas and finer lattices.
 *
 * <p>Uses {@code benchmarks.rigid}, {@code elastic} and {@code frame}. One thread. Millimetres and
 * newtons.
 */
package org.palpate.benchmarks.elastic;
