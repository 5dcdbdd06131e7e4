/**
 * Shares between the format readers: header lines, data files, sample streams, rescaling, grids and
 * the memory check.
 *
 * <p>Uses {@code io.volume} and {@code io.file}. An instance is for one thread. Millimetres and
 * bytes.
 */
package org.palpate.io.format;
