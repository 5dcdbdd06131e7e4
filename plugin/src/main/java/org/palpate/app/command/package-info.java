/**
 * The commands of the command line and the steps of each: touch, replay, render, info and devices.
 *
 * <p>Uses {@code app.options}, {@code app.output}, {@code host} and {@code scene}. A command runs
 * on the thread that calls it; a session adds its haptic thread. Millimetres and newtons.
 */
package org.palpate.app.command;
