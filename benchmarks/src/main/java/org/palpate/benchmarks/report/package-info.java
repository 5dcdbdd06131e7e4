/**
 * Draws charts, writes tables, prints progress lines and describes the machine for all studies.
 *
 * <p>Uses {@code io.file} and {@code io.table}. Any thread. No units.
 */
package org.palpate.benchmarks.report;
