/**
 * Bit cubes, the voxel grid that they fill, segments, and grey values.
 *
 * <p>Uses {@code geometry}. One thread changes the bits: the haptic thread while a session runs.
 * Any thread may read what no thread changes. In grid coordinates voxel (i,j,k) is the closed cell
 * [i,i+1]x[j,j+1]x[k,k+1]; spacing is in millimetres.
 */
package org.palpate.volume;
