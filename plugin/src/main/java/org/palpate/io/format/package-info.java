/**
 * What the format readers share: header lines, data files, sample streams, rescaling, grids and the
 * memory check.
 *
 * <p>Uses {@code io.volume} and {@code io.file}. One thread an instance. Millimetres and bytes.
 */
package org.palpate.io.format;
