/**
 * Reads NIfTI-1 and NIfTI-2, and writes the header of both.
 *
 * <p>Uses {@code io.format}, {@code io.volume} and {@code io.file}. An instance is for one thread.
 * World axes are RAS, in millimetres.
 */
package org.palpate.io.nifti;
