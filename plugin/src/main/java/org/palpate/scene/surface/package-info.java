/**
 * Extracts closed triangle meshes from bit cubes and grey values, brick by brick, and exports them.
 *
 * <p>Uses {@code volume}. Each class states its thread. Grid millimetres.
 */
package org.palpate.scene.surface;
