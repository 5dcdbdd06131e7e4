/**
 * Response: the solvers that move the interaction point after the device, and the legs that it
 * travels.
 *
 * <p>Uses {@code raycast}. An instance keeps scratch and belongs to the haptic thread. Positions
 * are grid coordinates, lengths and distances are millimetres.
 */
package org.palpate.proxy;
