/**
 * Draws and saves the charts of the studies.
 *
 * <p>Uses {@code io.file}. Every study uses it, which is why it is a package of its own. Any
 * thread. No units.
 */
package org.palpate.benchmarks.report;
