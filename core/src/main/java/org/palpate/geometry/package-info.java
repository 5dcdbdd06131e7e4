/**
 * Vectors, quaternions, rigid poses and transforms, boxes, deviations of arcs from chords, and the
 * metric of a voxel grid.
 *
 * <p>Uses the JDK alone. Mutable classes belong to one thread; records may be shared. Each class
 * states its frame; lengths are millimetres unless a name says voxels.
 */
package org.palpate.geometry;
