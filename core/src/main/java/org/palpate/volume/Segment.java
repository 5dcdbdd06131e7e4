package org.palpate.volume;

/**
 * A named set of voxels of a grid: an object that can be touched.
 *
 * @param name the name that the user gave, unique in its volume
 * @param bits the solid voxels
 * @param rgb the colour for drawing, 0xRRGGBB
 */
public record Segment(String name, BitCube bits, int rgb) {}
