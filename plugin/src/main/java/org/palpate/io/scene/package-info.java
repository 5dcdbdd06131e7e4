/**
 * Reads and writes scene files: bodies with their poses, tool, device and materials as JSON. Those
 * of an autosave have names of their own.
 *
 * <p>Uses {@code io.table}, {@code io.volume}, {@code io.mesh} and {@code body}. Any thread. Poses
 * map the rest position of a body to its present one, world mm. The world is that of the first
 * volume of a scene.
 */
package org.palpate.io.scene;
