/**
 * The collision scene: the union of bit cubes that tools collide with, its broad phase, and the
 * search for the nearest free voxel. Also a bounding-volume tree over boxes that move, and the port
 * to devices that judge many legs at once.
 *
 * <p>Uses {@code raycast}, {@code volume}, {@code geometry} and {@code statistics}. Belongs to the
 * haptic thread and allocates nothing in a query. Positions are grid coordinates; distances are
 * millimetres.
 */
package org.palpate.collision;
