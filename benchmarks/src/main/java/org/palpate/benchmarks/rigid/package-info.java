/**
 * Measures rigid tools with six degrees of freedom: the guarantee, times, forces, tight places, and
 * published methods beside them.
 *
 * <p>Uses {@code rigid}, {@code benchmarks.accuracy}, {@code benchmarks.moving}, {@code
 * benchmarks.report} and {@code benchmarks.shell}. One thread; times come from processes of their
 * own. Millimetres, radians and newtons.
 */
package org.palpate.benchmarks.rigid;
