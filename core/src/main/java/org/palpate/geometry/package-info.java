/**
 * Vectors, rigid transforms and boxes: mutable carriers that are written into, destination last.
 *
 * <p>Uses the JDK alone. No thread of its own; an instance belongs to one thread at a time. Units
 * and frame are those of the caller and stand in the caller's names.
 */
package org.palpate.geometry;
