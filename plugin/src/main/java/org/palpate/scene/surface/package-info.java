/**
 * Surfaces of bit cubes: closed triangle meshes, by brick and in parallel, coarse first, and their
 * export.
 *
 * <p>Uses {@code volume} and {@code geometry}; knows nothing of OpenGL. Positions are grid
 * millimetres (grid coordinates times spacing); a pose takes them to the world. Extraction reads
 * bits from any thread that sees the last edit.
 */
package org.palpate.scene.surface;
