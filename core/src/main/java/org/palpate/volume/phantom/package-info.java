/**
 * Volumes made by formula: what is there to touch where there is no scan, with the truth to measure
 * against.
 *
 * <p>Uses {@code volume} and {@code geometry}. No threads; every answer depends on its arguments
 * alone and is the same to the bit on every JDK (plus, minus, times, divide, square root). Grid
 * coordinates; voxels are cubes of 1 mm.
 */
package org.palpate.volume.phantom;
