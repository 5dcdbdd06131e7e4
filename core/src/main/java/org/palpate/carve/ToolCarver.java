package org.palpate.carve;

import org.palpate.body.BodyScene;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.BlockingVoxels;

/**
 * Cuts with a rigid tool: removes voxels that keep it from its device pose, the nearest first; see
 * {@link BlockingVoxels}. What is left still blocks the tool, so it rests there until the next cut.
 *
 * <p>Haptic thread only; allocates nothing.
 */
public final class ToolCarver {
  private final BlockingVoxels blocking;
  private final VoxelCutter cutter;
  private final BlockingVoxels.Sink sink;

  /**
   * Creates a carver.
   *
   * @param settings the rate, and what must not be cut
   * @param bodies the bodies, each of which is the segment of {@code out} with the same index
   * @param blocking finds the voxels that keep the tool from its device pose
   * @param out removes the voxels
   */
  public ToolCarver(
      CarveSettings settings, BodyScene bodies, BlockingVoxels blocking, VoxelWriter out) {
    this.blocking = blocking;
    double[] voxelMm3 = new double[bodies.count()];
    for (int n = 0; n < voxelMm3.length; n++) {
      Vec3 spacing = bodies.body(n).grid().spacingMm();
      voxelMm3[n] = spacing.x * spacing.y * spacing.z;
    }
    cutter = new VoxelCutter(settings, voxelMm3, out);
    sink = cutter::cut;
  }

  /**
   * Cuts in a frame, before the tool moves.
   *
   * @param device the device pose, finite, with a quaternion of norm 1
   * @param forceNewton the force on the hand in the last frame, N
   * @param nanos the time since that frame
   */
  public void carve(Pose device, double forceNewton, long nanos) {
    if (cutter.begin(forceNewton, nanos)) {
      blocking.find(device, sink);
    }
  }
}
