/**
 * The contract of a volume that is read slice by slice: header, voxel types, read options and the
 * refusal of a file.
 *
 * <p>Uses {@code io.file}, {@code volume} and {@code geometry}. One thread an instance. Sizes in
 * voxels, spacing in millimetres, coordinates in the file's own world axes.
 */
package org.palpate.io.volume;
