/**
 * The picture of what is touched: surfaces, the view, the 30 Hz synchronization thread.
 *
 * <p>Uses {@code sync}, {@code volume}, {@code geometry}; JOGL stands here alone. World
 * millimetres.
 */
package org.palpate.scene;
