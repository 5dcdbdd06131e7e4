/**
 * Runs one haptic frame as a plain method, with its settings, its statistics, and the watchdog that
 * judges the device's samples.
 *
 * <p>Uses {@code device}, {@code edit}, {@code proxy} and {@code force}. Owns no thread and no
 * clock: the caller's thread is the haptic thread. Grid coordinates, newtons, nanoseconds.
 */
package org.palpate.frame;
