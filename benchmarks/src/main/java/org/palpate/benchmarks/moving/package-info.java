/**
 * Attacks bodies that move among each other and against a tool, and judges every leg of every pair
 * exactly.
 *
 * <p>Uses {@code benchmarks.stress}, {@code fracture} and {@code rigid}. One thread. Poses are
 * world mm; legs are in grid coordinates of a body.
 */
package org.palpate.benchmarks.moving;
