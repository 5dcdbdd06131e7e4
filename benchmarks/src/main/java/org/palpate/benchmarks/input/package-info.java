/**
 * Seeded trajectories, rays and scans that several benchmarks share.
 *
 * <p>Uses {@code volume.phantom} and {@code io}. Any one thread. Grid coordinates.
 */
package org.palpate.benchmarks.input;
