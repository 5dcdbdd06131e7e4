/**
 * Makes rigid tools from shapes, segments and meshes: the sample points that represent the tool,
 * their tree of bounding spheres, and the mass properties behind its metric.
 *
 * <p>Uses {@code volume} and {@code geometry}. Tools are immutable once made and may be shared;
 * making one takes a single thread. Tool frames are in mm with the reference point at the origin.
 */
package org.palpate.rigid.tool;
