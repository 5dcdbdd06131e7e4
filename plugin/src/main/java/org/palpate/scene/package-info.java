/**
 * The picture of what is touched: the model of the scene and the 30 Hz synchronization thread.
 * Below it, {@code surface} makes its meshes, {@code gl} draws it, {@code window} shows it.
 *
 * <p>Uses {@code sync}, {@code volume}, {@code geometry}; JOGL stands in the packages below alone.
 * World millimetres come in; inside, the scene's frame has x to the left, y to the back, z to the
 * head. The model is changed by any thread; OpenGL is called by the one thread that draws.
 */
package org.palpate.scene;
