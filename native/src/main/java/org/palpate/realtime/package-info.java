/**
 * Sets up the haptic thread and waits for its deadlines: park, sleep, absolute sleep, spin, or
 * sleep and then spin.
 *
 * <p>Uses {@code loop}, whose ports it implements, and {@code realtime.os}. Set-up and waiting run
 * in the haptic thread; a wait allocates nothing. Nanoseconds of {@code System.nanoTime}.
 */
package org.palpate.realtime;
