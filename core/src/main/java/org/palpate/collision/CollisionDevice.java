package org.palpate.collision;

import java.util.Optional;
import org.palpate.volume.BitCube;

/**
 * Judges whether legs touch solid voxels: the CPU, or a device that judges many legs at once.
 *
 * <p>Invariant: {@link LegVerdict#FREE} and {@link LegVerdict#HIT} are exact on every device, and
 * {@link LegBatch#emptyAround} is never too large. Verification skips a leg that is free or within
 * an empty cube, and casts every other one. So a device changes no bit of an answer, and the
 * guarantee rests on this invariant.
 *
 * <p>One thread at a time uses a device; {@link #failure} and {@link #close} are for any thread.
 */
public interface CollisionDevice extends AutoCloseable {
  /** The CPU. */
  CollisionDevice CPU = new CpuCollisionDevice();

  /**
   * Hands voxels to the device. Allocates.
   *
   * @param voxels the caller reports changes by {@link DeviceVoxels#voxelsChanged}
   * @return the voxels as the device keeps them
   */
  DeviceVoxels keep(BitCube voxels);

  /** {@return the name of the device, for people} */
  String name();

  /**
   * {@return why the device judges nothing any more; empty while it works} The CPU then does its
   * work.
   */
  Optional<String> failure();

  /** {@return the number of batches that the device has judged, each in one launch} */
  long batches();

  /** Frees the device's memory unless a call hangs in it. It judges nothing afterwards. */
  @Override
  void close();
}
