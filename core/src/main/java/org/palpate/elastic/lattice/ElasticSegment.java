package org.palpate.elastic.lattice;

import org.palpate.volume.BitCube;

/**
 * A segment that deforms.
 *
 * @param bits its voxels
 * @param material of all of them
 */
public record ElasticSegment(BitCube bits, ElasticMaterial material) {}
