/**
 * The user's input in dialogs and macros, with its checks, the help page and the error messages.
 *
 * <p>Uses {@code imagej.stack}, {@code host} and {@code io}. ImageJ's command thread. Calibrated
 * units of the image and newtons per millimetre.
 */
package org.palpate.imagej.dialog;
