/**
 * The port to a volume platform: contact scene, live session, replay, view and devices.
 *
 * <p>Uses {@code loop}, {@code proxy}, {@code scene.window}, {@code device.jni} and {@code
 * io.table}. Each class states its thread. World millimetres outside, grid coordinates inside.
 */
package org.palpate.host;
