/**
 * The command {@code bench}, which runs every study.
 *
 * <p>Uses all studies and {@code app}. One thread. Units are in the names of columns and keys.
 */
package org.palpate.benchmarks.command;
