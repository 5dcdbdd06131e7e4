/**
 * The port to haptic devices, with a simulated device and a device that replays a trajectory.
 *
 * <p>Uses {@code geometry}. The haptic thread reads and writes a device; whoever opened a device
 * closes it. World millimetres and newtons.
 */
package org.palpate.device;
