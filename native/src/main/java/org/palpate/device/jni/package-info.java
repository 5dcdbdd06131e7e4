/**
 * Connects Java to the C++ device layer: one direct buffer, one call to read and one to write a
 * frame.
 *
 * <p>Uses {@code device}. The haptic thread reads and writes. Millimetres and newtons in the
 * device's own frame. The only package with JNI methods.
 */
package org.palpate.device.jni;
