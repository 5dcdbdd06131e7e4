/**
 * Reads TIFF and BigTIFF stacks, with ImageJ's calibration.
 *
 * <p>Uses {@code io.codec}, {@code io.format}, {@code io.volume} and {@code io.file}. An instance
 * is for one thread. Spacing in millimetres; the patient's axes are unknown.
 */
package org.palpate.io.tiff;
