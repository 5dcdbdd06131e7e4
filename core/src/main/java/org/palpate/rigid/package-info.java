/**
 * Moves rigid tools of many points: exact verification of a motion of all points, contact
 * constraints, and the solver with six degrees of freedom.
 *
 * <p>Uses {@code rigid.tool}, {@code rigid.skip}, {@code body}, {@code raycast} and the field of
 * {@code proxy.smooth}. Solver classes belong to the haptic thread, allocate nothing in a frame and
 * take no lock. Tool frames are in mm with the reference point at the origin; legs and voxels are
 * in grid coordinates of a body.
 */
package org.palpate.rigid;
