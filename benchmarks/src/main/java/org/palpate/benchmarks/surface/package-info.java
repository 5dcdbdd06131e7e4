/**
 * Measures the extraction of surfaces: triangles, time and memory.
 *
 * <p>Uses {@code scene.surface}, {@code benchmarks.input} and {@code benchmarks.report}. One
 * thread. Seconds and megabytes.
 */
package org.palpate.benchmarks.surface;
