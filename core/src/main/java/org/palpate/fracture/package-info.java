/**
 * Reads how the fragments of a bone fit: gap, step-off, contact area, overlap, and the distance to
 * the truth of a synthetic fracture.
 *
 * <p>Uses {@code volume.fracture}. Any thread, on bits that no other thread changes. Millimetres of
 * the world, degrees, and mm^2.
 */
package org.palpate.fracture;
