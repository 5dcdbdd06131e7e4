/**
 * Opens a volume in any known format, and writes volumes.
 *
 * <p>Uses every format package; no format package may use it. An instance is for one thread. Sizes
 * in voxels, spacing and positions in millimetres of the file's world.
 */
package org.palpate.io;
