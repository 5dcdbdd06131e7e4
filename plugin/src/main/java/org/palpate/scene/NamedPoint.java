package org.palpate.scene;

import org.palpate.geometry.Vec3;

/**
 * A landmark: a named point, drawn as a small ball with its name beside it.
 *
 * @param name the name
 * @param position position in mm, read-only; in the world or in the scene frame as the receiver
 *     states
 */
public record NamedPoint(String name, Vec3 position) {}
