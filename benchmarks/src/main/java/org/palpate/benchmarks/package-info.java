/**
 * JMH benchmarks of collision, response, volumes and whole frames.
 *
 * <p>Uses {@code benchmarks.baseline} and {@code benchmarks.input}. One thread per benchmark unless
 * its name says otherwise. Grid coordinates; each class states its unit of time.
 */
package org.palpate.benchmarks;
