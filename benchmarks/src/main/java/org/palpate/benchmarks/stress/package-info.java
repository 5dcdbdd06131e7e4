/**
 * The attack on the guarantee: hostile scenes, hostile motions, an exact judge of every leg, and
 * the smallest case of what fails.
 *
 * <p>Uses {@code proxy}, {@code raycast}, {@code volume} of core and {@code app} for its command.
 * One thread a run. Grid coordinates, millimetres.
 */
package org.palpate.benchmarks.stress;
