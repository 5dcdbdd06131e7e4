/**
 * Bit cubes, the voxel grid that they fill, segments, phantoms and editing.
 *
 * <p>Uses {@code geometry}. Bits are changed by one thread, the haptic thread while a session runs;
 * any thread may read what no one changes. Grid coordinates: voxel (i,j,k) is the closed cell
 * [i,i+1]x[j,j+1]x[k,k+1], outside is empty.
 */
package org.palpate.volume;
