/**
 * Rigid tools made of many points: their sampling and bounding-sphere tree, the exact verification
 * of a motion of all points, contact constraints, and the solver with six degrees of freedom.
 *
 * <p>Uses {@code body}, {@code raycast} and the field of {@code proxy.smooth}. Solver classes
 * belong to the haptic thread, allocate nothing in a frame and take no lock; tools are made
 * beforehand and may be shared. Tool frames are in mm with the reference point at the origin; legs
 * and voxels are in grid coordinates of a body.
 */
package org.palpate.rigid;
