/**
 * Run time against error, scaling, skips and jitter: JMH benchmarks and the commands that run them.
 *
 * <p>Uses everything. No test asserts a time; these show it.
 */
package org.palpate.benchmarks;
