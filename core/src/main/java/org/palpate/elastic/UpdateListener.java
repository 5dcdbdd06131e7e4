package org.palpate.elastic;

import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

/**
 * Receives the inputs of each update of a live session, for a recording. {@link RecordedUpdates}
 * computes the same fields from them again.
 */
public interface UpdateListener {
  /** Listens to nothing. */
  UpdateListener NONE =
      new UpdateListener() {
        @Override
        public void refilled(int cell, CellStiffness stiffness) {}

        @Override
        public void updating(Vec3 point, Vec3 forceNewton) {}

        @Override
        public void used(long update) {}
      };

  /**
   * Receives the stiffness of a cell whose voxels were counted anew for the next update. Thread of
   * the updates.
   *
   * @param cell its number by {@link org.palpate.elastic.lattice.ControlLattice.RefillSink}
   * @param stiffness the new stiffness, which nobody changes
   */
  void refilled(int cell, CellStiffness stiffness);

  /**
   * Receives the load of an update that begins. Thread of the updates.
   *
   * @param point the place of the load in material coordinates
   * @param forceNewton on the material, N
   */
  void updating(Vec3 point, Vec3 forceNewton);

  /**
   * Receives an update whose field comes into use. Haptic thread: must not wait or allocate.
   *
   * @param update the number of the update, from 0
   */
  void used(long update);
}
