package org.palpate.io.table;

import org.palpate.geometry.Vec3;

/**
 * A named point on a scan.
 *
 * @param name the name that the user gives
 * @param worldMm its position, world mm
 */
public record Landmark(String name, Vec3 worldMm) {}
