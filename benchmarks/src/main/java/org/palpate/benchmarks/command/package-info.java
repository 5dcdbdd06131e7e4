/** The command {@code bench}: chooses what to measure. Uses every other package of benchmarks. */
package org.palpate.benchmarks.command;
