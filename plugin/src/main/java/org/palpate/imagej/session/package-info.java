/**
 * The one live session of an ImageJ instance: its device, 3-D window, start and end.
 *
 * <p>Uses {@code imagej.annotation}, {@code imagej.dialog}, {@code imagej.stack} and {@code host}.
 * The session has a thread of its own; commands call it from theirs. World millimetres.
 */
package org.palpate.imagej.session;
