package org.palpate.elastic.lattice;

import org.palpate.volume.BitCube;

/**
 * A segment that deforms.
 *
 * @param bits its voxels
 * @param material of all of them
 * @param touchable whether a tool can touch it; otherwise it fills the space behind what it can
 */
public record ElasticSegment(BitCube bits, ElasticMaterial material, boolean touchable) {
  /**
   * Creates a segment that a tool can touch.
   *
   * @param bits the voxels of the segment; kept
   * @param material how they deform
   */
  public ElasticSegment(BitCube bits, ElasticMaterial material) {
    this(bits, material, true);
  }

  /** Returns this segment with voxels of its own, which edits do not change. */
  ElasticSegment copy() {
    return new ElasticSegment(bits.copy(), material, touchable);
  }
}
