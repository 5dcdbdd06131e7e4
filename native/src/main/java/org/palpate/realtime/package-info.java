/**
 * Scheduling class, affinity, memory lock and absolute sleep for the haptic thread, through JNA.
 *
 * <p>Uses {@code interaction}, whose ports it implements. The only package that uses JNA.
 */
package org.palpate.realtime;
