/**
 * The real-time laboratory: how late this JVM, these JVMs, these collectors wake up and run a
 * frame, and why.
 *
 * <p>A table is a list of {@link org.palpate.benchmarks.jitter.Cell cells}; each runs in a fresh
 * process ({@code CellMain}, or the control loop in C++) that leaves samples, a flight recording
 * and its answers in a folder; the analysis is a pure function of these files, so that a run can be
 * taken up where it ended. Nanoseconds of {@link System#nanoTime}, which is one clock for all
 * processes of a Linux machine.
 */
package org.palpate.benchmarks.jitter;
