/**
 * Measures the extraction of surfaces: triangles, time and memory.
 *
 * <p>Uses {@code scene.surface} and {@code benchmarks.input}. One thread. Seconds and megabytes.
 */
package org.palpate.benchmarks.surface;
