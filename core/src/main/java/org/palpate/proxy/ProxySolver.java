package org.palpate.proxy;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.statistics.SkipCounters;

/**
 * Moves the proxy of a haptic device once a frame: the {@link InteractionPoint} that follows the
 * device position and, with the solvers that keep the guarantee, never enters a solid.
 *
 * <p>The guarantee: no leg of the point, as the exact segment between its two doubles, touches a
 * closed solid voxel, and each leg starts bit for bit where the last one ended. {@code
 * GuardedSolver} and {@code SmoothSolver} keep it; the solvers of {@code
 * org.palpate.proxy.reference} do not.
 *
 * <p>Thread: an instance keeps scratch memory and belongs to the haptic thread. {@link #follow}
 * allocates nothing, takes no lock, and does a bounded amount of work.
 */
public interface ProxySolver {
  /**
   * Runs one frame: moves the point towards the device by at most w_max, and writes the legs and
   * the contact of this frame. Staying is always allowed.
   *
   * @param scene the solids of this frame; if they changed, {@link #reset} or {@link
   *     #resetAfterEdit} was called first
   * @param device the device position in grid coordinates, finite; not changed
   * @param point the point to move; it touches no solid when the frame begins
   */
  void follow(CollisionScene scene, Vec3 device, InteractionPoint point);

  /**
   * Forgets all that is kept from frame to frame. Call this after the solids changed, and after the
   * point was placed by anything but this solver.
   */
  default void reset() {}

  /**
   * Does the same as {@link #reset} after only the voxels of a box changed. A solver may then keep
   * what it knows of other voxels; its frames are the same to the bit.
   *
   * @param changed a box around the changed voxels, not empty
   */
  default void resetAfterEdit(IntBox changed) {
    reset();
  }

  /**
   * {@return the work of the last frame, in steps of the solver that no machine changes; 0 if the
   * solver does not count them}
   */
  default int steps() {
    return 0;
  }

  /**
   * Adds the number of times that this solver skipped work to counters.
   *
   * @param dest receives the counts; a solver that skips nothing leaves them
   */
  default void addSkips(SkipCounters dest) {}
}
