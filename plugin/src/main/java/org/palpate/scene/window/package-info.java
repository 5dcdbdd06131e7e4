/**
 * Where a scene is shown: the NEWT window with its mouse and keys, and pictures made without one.
 *
 * <p>Uses {@code scene}, {@code scene.gl} and JOGL. A window draws in a thread of its own; a
 * picture is drawn by its caller. Pixels.
 */
package org.palpate.scene.window;
