/**
 * What reaching hidapi from Java costs by ways that others take. In the tests, for JNA stands in
 * the product only in {@code realtime}, and hid4java nowhere.
 */
package org.palpate.benchmarks.crossing;
