/**
 * Runs one haptic frame as a plain method, with its settings, its statistics, the watchdog that
 * judges the device's samples, and the change of a device to grid coordinates.
 *
 * <p>Uses {@code device}, {@code carve}, {@code edit}, {@code proxy}, {@code rigid}, {@code force}
 * and {@code force.guide}. Owns no thread and no clock: the caller's thread is the haptic thread. A
 * point frame is in grid coordinates, a tool frame in world mm; newtons, N mm, nanoseconds.
 */
package org.palpate.frame;
