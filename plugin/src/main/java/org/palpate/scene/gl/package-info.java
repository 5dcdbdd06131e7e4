/**
 * How a scene's state is drawn with OpenGL 3.3.
 *
 * <p>Uses JOGL and the scene's model. One thread, with the context current. Scene frame, mm.
 */
package org.palpate.scene.gl;
