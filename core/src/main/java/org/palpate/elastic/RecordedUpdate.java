package org.palpate.elastic;

import java.util.List;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

/**
 * An update of a recorded session.
 *
 * @param frame the frame in which its field came into use, or {@link #UNUSED}
 * @param point the place of the load in material coordinates
 * @param forceNewton the force on the material, N
 * @param refills the cells whose voxels were counted anew before it
 */
public record RecordedUpdate(long frame, Vec3 point, Vec3 forceNewton, List<Refill> refills) {
  /** The frame of an update whose field was refused, or replaced by the next one. */
  public static final long UNUSED = -1;

  /**
   * The stiffness of a cell after an edit.
   *
   * @param cell its number by {@link org.palpate.elastic.lattice.ControlLattice.RefillSink}
   * @param stiffness the stiffness from the edit on
   */
  public record Refill(int cell, CellStiffness stiffness) {}
}
