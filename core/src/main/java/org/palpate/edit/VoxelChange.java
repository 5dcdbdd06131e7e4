package org.palpate.edit;

/**
 * A change of one voxel in a recording.
 *
 * @param frame the frame that made it, from 0
 * @param segment index of the segment in the scene
 * @param i the voxel, as are j and k
 * @param solid whether it became solid; empty else
 */
public record VoxelChange(long frame, int segment, int i, int j, int k, boolean solid) {}
