/**
 * Reads TIFF and BigTIFF stacks and folders of slices, with what ImageJ and OME-XML state of them.
 *
 * <p>Uses {@code io.codec}, {@code io.format}, {@code io.volume} and {@code io.file}. An instance
 * is for one thread. Spacing in millimetres; the patient's axes are unknown.
 */
package org.palpate.io.tiff;
