/**
 * Reads DICOM files and series as volumes. Positions decide the order and spacing of slices.
 *
 * <p>Uses {@code io.codec}, {@code io.format}, {@code io.volume} and {@code io.file}. Reads no
 * attribute that identifies a patient. An instance is for one thread. World axes are LPS, in
 * millimetres.
 */
package org.palpate.io.dicom;
