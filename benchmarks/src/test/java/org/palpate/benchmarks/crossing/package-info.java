/**
 * Measures the cost of calling hidapi from Java by other libraries. It stands among the tests,
 * because the product uses JNA only in {@code realtime} and {@code display}, and hid4java nowhere.
 */
package org.palpate.benchmarks.crossing;
