/**
 * The port to haptic devices: what is read, what is written, what a device can do; the simulated
 * and the replay device.
 *
 * <p>Uses {@code geometry}. Read and written by the haptic thread, closed by whoever opened it.
 * World millimetres and newtons.
 */
package org.palpate.device;
