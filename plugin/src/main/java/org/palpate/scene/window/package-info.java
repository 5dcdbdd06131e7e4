/**
 * The window with mouse and keys, and rendering without a window.
 *
 * <p>Uses {@code scene.gl} and JOGL's NEWT. NEWT's thread delivers events; a thread of its own
 * draws. Pixels.
 */
package org.palpate.scene.window;
