/**
 * The contract of a volume that is read slice by slice: header, voxel types, read options and the
 * exception for a file that is refused.
 *
 * <p>Uses {@code io.file}, {@code volume} and {@code geometry}. An instance is for one thread.
 * Sizes in voxels, spacing in millimetres, coordinates in the file's own world axes.
 */
package org.palpate.io.volume;
