/**
 * Bodies of voxels in a scene, each with its own grid, pose and mobility, and the clearance queries
 * that a tool of many points asks of them.
 *
 * <p>Uses {@code collision}, {@code volume} and {@code geometry}. Bodies belong to the haptic
 * thread; queries allocate nothing. Poses are rest to present, world mm; voxels and clearances are
 * in grid coordinates of the body.
 */
package org.palpate.body;
