package org.palpate.edit;

/**
 * A change of one voxel in a recording.
 *
 * @param frame the frame that made it, from 0
 * @param segment index of the segment in the scene
 * @param i index of the voxel along x
 * @param j its index along y
 * @param k its index along z
 * @param solid whether the voxel became solid; otherwise it became empty
 */
public record VoxelChange(long frame, int segment, int i, int j, int k, boolean solid) {}
