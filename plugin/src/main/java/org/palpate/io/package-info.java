/**
 * Volume files in, tables and pictures out; the only package that knows file formats.
 *
 * <p>{@link org.palpate.io.VolumeFiles#open} finds the format and gives a {@link
 * org.palpate.io.VolumeReader}: its header, and its values one slice after the other. {@link
 * org.palpate.io.SegmentBuilder} makes bits of them without keeping the grey values. Uses {@code
 * volume}. World millimetres; any one thread.
 */
package org.palpate.io;
