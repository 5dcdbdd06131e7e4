/**
 * Opens a volume in any known format and writes volumes.
 *
 * <p>Uses every format package; no format package may use it. One thread an instance. Sizes in
 * voxels, spacing and positions in millimetres of the file's world.
 */
package org.palpate.io;
