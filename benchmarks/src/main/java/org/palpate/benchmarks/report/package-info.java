/**
 * Draws charts, prints progress lines and describes the machine for all studies.
 *
 * <p>Uses {@code io.file}. Any thread. No units.
 */
package org.palpate.benchmarks.report;
