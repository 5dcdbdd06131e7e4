/**
 * How true forces are: solvers pressed into surfaces known by formula, slid along them, and
 * compared with what the surface itself would give; as tables and pictures.
 *
 * <p>Uses {@code proxy}, {@code force} and the phantoms. One thread. Millimetres unless a name says
 * otherwise.
 */
package org.palpate.benchmarks.accuracy;
