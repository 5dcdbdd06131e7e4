/**
 * The solvers of the published methods, as baselines. They do not keep the collision guarantee.
 *
 * <p>Uses {@code proxy}, {@code collision} and {@code raycast}. Belongs to the haptic thread.
 * Positions are grid coordinates; lengths are millimetres.
 */
package org.palpate.proxy.reference;
