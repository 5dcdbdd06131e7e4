/**
 * Crops, resamples and mirrors volumes.
 *
 * <p>Uses {@code io}. An instance is for one thread and keeps the whole source in memory. Voxel
 * numbers are in grid coordinates; planes are in world mm.
 */
package org.palpate.io.resample;
