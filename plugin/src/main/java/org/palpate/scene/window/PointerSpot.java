package org.palpate.scene.window;

import org.palpate.geometry.Vec3;

/**
 * A spot of the picture that the user presses with the mouse. World mm; read-only.
 *
 * @param eyeMm position of the viewer
 * @param surfaceMm the point that the picture shows under the mouse; of a deformed surface its
 *     position at rest, so that a drag does not sink into its own dimple
 * @param depthMm depth of the press below the surface
 * @param begins whether a press begins here; otherwise a drag continues from the last spot
 */
public record PointerSpot(Vec3 eyeMm, Vec3 surfaceMm, double depthMm, boolean begins) {}
