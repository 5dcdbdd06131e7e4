/**
 * The bridge to the C++ device layer: one direct buffer, one call to read and one to write a frame.
 *
 * <p>Uses {@code device}. Haptic thread; the only package with native methods.
 */
package org.palpate.device.jni;
