/**
 * The interaction point, the path that it travels in a frame, and the interface of the solvers that
 * move it.
 *
 * <p>Uses {@code collision} and what stands below it. Belongs to the haptic thread. Positions are
 * grid coordinates; path lengths are millimetres.
 */
package org.palpate.proxy;
