/**
 * Makes rigid tools from what a user writes: shapes, meshes, and segments of volume files.
 *
 * <p>Uses {@code rigid}, {@code io} and {@code io.mesh}. One thread. World millimetres.
 */
package org.palpate.tool;
