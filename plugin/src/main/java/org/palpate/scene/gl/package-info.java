/**
 * Draws a scene state with OpenGL 3.3.
 *
 * <p>Uses {@code scene} and JOGL. Belongs to the one thread that has the context current. World
 * millimetres and pixels.
 */
package org.palpate.scene.gl;
