/**
 * The speed study: the JMH benchmarks, chosen, run in fresh processes and written down as tables
 * and plots.
 *
 * <p>Uses the benchmarks themselves, {@code io} for files. Times are medians over all iterations of
 * all forks, with the least and the greatest: processor time of the one thread, or the wall clock
 * where several work.
 */
package org.palpate.benchmarks.speed;
