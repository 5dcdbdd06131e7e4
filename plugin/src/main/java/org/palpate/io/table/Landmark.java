package org.palpate.io.table;

import org.palpate.geometry.Vec3;

/**
 * A named point on a scan.
 *
 * @param name as the user gave it
 * @param worldMm where it is, world mm
 */
public record Landmark(String name, Vec3 worldMm) {}
