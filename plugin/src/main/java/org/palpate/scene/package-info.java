/**
 * The picture of what is touched: the model of the scene, the 30 Hz synchronization thread, the
 * window and the pictures made without one.
 *
 * <p>Uses {@code sync}, {@code volume}, {@code geometry}; JOGL stands here and in the packages
 * below alone. World millimetres come in; inside, the scene's frame has x to the left, y to the
 * back, z to the head. The model is changed by any thread; OpenGL is called by the one thread that
 * draws.
 */
package org.palpate.scene;
