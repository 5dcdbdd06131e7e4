/**
 * What makes a JVM's thread wake on time: scheduling class, affinity, memory lock, timer slack and
 * an absolute sleep, through JNA's direct mapping; each granted or refused in one word.
 *
 * <p>Uses {@code interaction}, whose ports it implements. The only package that uses JNA. What sets
 * a thread up is called by that thread, once, before its first frame; what waits is called every
 * frame and allocates nothing. Nanoseconds of {@link System#nanoTime}.
 */
package org.palpate.realtime;
