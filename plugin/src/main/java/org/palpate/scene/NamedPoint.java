package org.palpate.scene;

import org.palpate.geometry.Vec3;

/**
 * A landmark: a place with a name, drawn as a small ball with its name beside it.
 *
 * @param place mm, not to be changed; world or scene frame as whoever takes it says
 */
public record NamedPoint(String name, Vec3 place) {}
