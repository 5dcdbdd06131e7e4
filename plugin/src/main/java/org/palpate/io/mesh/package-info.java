/**
 * Reads meshes of triangles from STL, OBJ and PLY files.
 *
 * <p>Uses {@code io.format} and {@code rigid.tool}. One thread. Coordinates are those of the file,
 * in mm.
 */
package org.palpate.io.mesh;
