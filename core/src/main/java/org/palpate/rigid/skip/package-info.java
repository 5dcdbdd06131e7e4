/**
 * Finds what the verification of a motion need not test: points and nodes of a tool's tree that are
 * known to be free of solids.
 *
 * <p>Uses {@code rigid.tool} and {@code body}. All classes belong to the haptic thread and allocate
 * nothing in a frame. Tool frames are in mm; solids are in grid coordinates of a bit cube, in
 * cells.
 */
package org.palpate.rigid.skip;
