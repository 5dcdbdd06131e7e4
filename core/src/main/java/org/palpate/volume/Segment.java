package org.palpate.volume;

/**
 * A named set of voxels of a grid, an object that can be touched.
 *
 * @param name as the user gave it, unique in its volume
 * @param bits which voxels are solid
 * @param rgb colour for drawing, 0xRRGGBB
 */
public record Segment(String name, BitCube bits, int rgb) {}
