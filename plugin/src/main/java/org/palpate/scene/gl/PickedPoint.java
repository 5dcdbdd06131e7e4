package org.palpate.scene.gl;

import org.palpate.geometry.Vec3;

/**
 * A point of a surface that a pixel shows.
 *
 * @param surfaceMm the point, scene frame
 * @param eyeMm the position of the eye that sees it there, scene frame; one of two in stereo
 */
public record PickedPoint(Vec3 surfaceMm, Vec3 eyeMm) {}
