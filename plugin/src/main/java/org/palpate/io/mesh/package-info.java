/**
 * Reads meshes of triangles from STL, OBJ and PLY files.
 *
 * <p>Uses {@code io.format} and {@code rigid.tool}. One thread. Coordinates are in mm: those of the
 * file, or of a world into which its axes are turned.
 */
package org.palpate.io.mesh;
