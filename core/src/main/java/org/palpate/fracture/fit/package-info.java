/**
 * Fits the fracture faces of a fragment to the faces that they face.
 *
 * <p>Uses {@code fracture} and {@code force.guide}. Any thread but the haptic one, on bits that may
 * change meanwhile. Millimetres of the world, radians.
 */
package org.palpate.fracture.fit;
